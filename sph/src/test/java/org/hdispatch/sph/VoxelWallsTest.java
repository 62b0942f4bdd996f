package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.hdispatch.cell.Ends;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class VoxelWallsTest {
  private static final double EDGE = 0.25;

  @ParameterizedTest
  @CsvSource({
    "OPEN, OPEN, OPEN",
    "PERIODIC, OPEN, OPEN",
    "OPEN, PERIODIC, PERIODIC",
    "PERIODIC, PERIODIC, PERIODIC"
  })
  void middlesOfVoxelsAreAsFarAsTheNearestOfTheOtherKind(Ends x, Ends y, Ends z) {
    for (double porosity : new double[] {0.03, 0.4, 0.97}) {
      Random random = new Random(2012);
      boolean[] solid = new boolean[9 * 6 * 7];
      for (int n = 0; n < solid.length; n++) {
        solid[n] = random.nextDouble() >= porosity;
      }
      VoxelWalls.Image image = (i, j, k) -> solid[i + 9 * (j + 6 * k)];
      VoxelWalls walls = new VoxelWalls(9, 6, 7, EDGE, x, y, z, image);
      for (int k = 0; k < 7; k++) {
        for (int j = 0; j < 6; j++) {
          for (int i = 0; i < 9; i++) {
            double found = walls.at((i + 0.5) * EDGE, (j + 0.5) * EDGE, (k + 0.5) * EDGE);
            double expected = EDGE * nearest(image, x, y, z, i, j, k);
            assertEquals(expected, found, 1e-6); // floats
          }
        }
      }
    }
  }

  /** By looking at every voxel as far as 9 away, in voxels. */
  private static double nearest(
      VoxelWalls.Image image, Ends x, Ends y, Ends z, int i, int j, int k) {
    boolean own = image.isSolid(i, j, k);
    int least = Integer.MAX_VALUE;
    for (int dk = -9; dk <= 9; dk++) {
      for (int dj = -9; dj <= 9; dj++) {
        for (int di = -9; di <= 9; di++) {
          int xi = x.wrap(i + di, 9);
          int yj = y.wrap(j + dj, 6);
          int zk = z.wrap(k + dk, 7);
          boolean solid = xi < 0 || yj < 0 || zk < 0 || image.isSolid(xi, yj, zk);
          if (solid != own) {
            least = Math.min(least, di * di + dj * dj + dk * dk);
          }
        }
      }
    }
    return own ? 0.5 - Math.sqrt(least) : Math.sqrt(least) - 0.5;
  }

  @Test
  void planeWallsAreExactEverywhere() {
    VoxelWalls walls =
        new VoxelWalls(
            4, 20, 3, EDGE, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC, (i, j, k) -> j < 8);
    WallDistance exact = Walls.slit(8 * EDGE, 20 * EDGE);
    Random random = new Random(5);
    for (int n = 0; n < 1000; n++) {
      double x = 3 * random.nextDouble() - 1; // of the box and beyond
      double y = (6 + 7 * random.nextDouble()) * EDGE;
      double z = random.nextDouble();
      assertEquals(exact.at(x, y, z), walls.at(x, y, z), 1e-6); // floats
    }
  }

  /** Steps of the surface are 1 high: the distance of a sphere errs by half of that at most. */
  @Test
  void roundWallsAreRightToHalfAVoxel() {
    int n = 40;
    ParticleBox box = ParticleBox.space(n, n, n, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
    WallDistance exact = Walls.spheres(box, List.of(new Walls.Sphere(20, 20, 20, 13.3)));
    VoxelWalls walls =
        new VoxelWalls(
            n,
            n,
            n,
            1,
            Ends.PERIODIC,
            Ends.PERIODIC,
            Ends.PERIODIC,
            (i, j, k) -> exact.at(i + 0.5, j + 0.5, k + 0.5) <= 0);
    Random random = new Random(6);
    double squares = 0;
    int count = 0;
    for (int m = 0; m < 10_000; m++) {
      double x = n * random.nextDouble();
      double y = n * random.nextDouble();
      double z = n * random.nextDouble();
      if (Math.abs(exact.at(x, y, z)) < 4) { // farther away nobody asks
        double apart = walls.at(x, y, z) - exact.at(x, y, z);
        assertEquals(0, apart, 0.5);
        squares += apart * apart;
        count++;
      }
    }
    assertTrue(count > 1000);
    assertEquals(0, Math.sqrt(squares / count), 0.25); // of a voxel
  }

  @Test
  void planesOfVoxelsServeTwoDimensions() {
    VoxelWalls walls =
        new VoxelWalls(8, 8, 1, 1, Ends.PERIODIC, Ends.OPEN, Ends.PERIODIC, (i, j, k) -> j > 4);
    assertEquals(0.5, walls.at(3, 0.5, 0), 1e-6); // what lies beyond an open end is solid
    assertEquals(-1.5, walls.at(3, 6.5, 0), 1e-6);
  }

  /** Nothing is asked about z then. */
  @Test
  void oneVoxelAlongZIsForTwoDimensions() {
    IllegalArgumentException thrown =
        assertThrows(
            IllegalArgumentException.class,
            () -> new VoxelWalls(4, 4, 1, 1, Ends.OPEN, Ends.OPEN, Ends.OPEN, (i, j, k) -> true));
    assertTrue(thrown.getMessage().endsWith("nz=1, z=OPEN"), thrown.getMessage());
  }

  @Test
  void voxelsMustBeAny() {
    IllegalArgumentException thrown =
        assertThrows(
            IllegalArgumentException.class,
            () -> new VoxelWalls(0, 1, 1, 1, Ends.OPEN, Ends.OPEN, Ends.OPEN, (i, j, k) -> false));
    assertTrue(thrown.getMessage().contains("voxels=0 x 1 x 1"), thrown.getMessage());
  }
}
