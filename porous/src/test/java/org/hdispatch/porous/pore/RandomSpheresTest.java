package org.hdispatch.porous.pore;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RandomSpheresTest {
  private static final int SIZE = 24;
  private static final RandomSpheres SPHERES = new RandomSpheres(3.3, 2011);

  @Test
  void firstSphereHasAllItsVoxelsAcrossTheSidesToo() {
    RandomSpheres large = new RandomSpheres(8, 5);
    Random random = new Random(5);
    double[] centre = {random.nextDouble(), random.nextDouble(), random.nextDouble()};
    PoreSpace one = large.poreSpace(SIZE, 0.9); // 2145 voxels of 13824
    int solid = 0;
    for (int z = 0; z < SIZE; z++) {
      for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
          double least = Double.POSITIVE_INFINITY;
          for (int image = 0; image < 27; image++) {
            double dx = x - SIZE * (centre[0] + image % 3 - 1);
            double dy = y - SIZE * (centre[1] + image / 3 % 3 - 1);
            double dz = z - SIZE * (centre[2] + image / 9 - 1);
            least = Math.min(least, dx * dx + dy * dy + dz * dz);
          }
          assertEquals(least > 64, one.isPore(x, y, z), x + " " + y + " " + z);
          solid += least > 64 ? 0 : 1;
        }
      }
    }
    assertEquals(4 * Math.PI / 3 * 512, solid, 60); // staircase of a sphere 16 voxels across
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.3, 0.8})
  void porosityIsAtMostASphereBelowWhatIsAsked(double porosity) {
    double sphere = 4 * Math.PI / 3 * Math.pow(4, 3) / Math.pow(SIZE, 3); // with all it touches
    double made = SPHERES.poreSpace(SIZE, porosity).porosity();
    assertTrue(made <= porosity && made > porosity - sphere, "porosity " + made);
  }

  @Test
  void tighterRockHasTheSpheresOfALooserOne() {
    PoreSpace tight = SPHERES.poreSpace(SIZE, 0.2);
    PoreSpace loose = SPHERES.poreSpace(SIZE, 0.5);
    for (int n = 0; n < tight.voxels(); n++) {
      assertTrue(loose.isPore(n) || !tight.isPore(n), "voxel " + n);
    }
  }

  @Test
  void seedDecides() {
    PoreSpace rock = SPHERES.poreSpace(SIZE, 0.3);
    PoreSpace again = new RandomSpheres(3.3, 2011).poreSpace(SIZE, 0.3);
    PoreSpace other = new RandomSpheres(3.3, 2012).poreSpace(SIZE, 0.3);
    int different = 0;
    for (int n = 0; n < rock.voxels(); n++) {
      assertEquals(rock.isPore(n), again.isPore(n));
      different += rock.isPore(n) == other.isPore(n) ? 0 : 1;
    }
    assertTrue(different > rock.voxels() / 10, "voxels that differ: " + different);
  }

  @Test
  void numbersThatAreNoneAreRefused() {
    for (double bad : new double[] {0, 1, -0.1, 2, Double.NaN}) {
      assertThrows(IllegalArgumentException.class, () -> SPHERES.poreSpace(SIZE, bad));
    }
    for (double bad : new double[] {0, 0.9, 1e5, Double.NaN}) {
      assertThrows(IllegalArgumentException.class, () -> new RandomSpheres(bad, 1));
    }
    assertThrows(IllegalArgumentException.class, () -> SPHERES.poreSpace(0, 0.3));
  }
}
