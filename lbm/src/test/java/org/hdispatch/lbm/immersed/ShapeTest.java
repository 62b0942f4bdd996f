package org.hdispatch.lbm.immersed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.hdispatch.lbm.immersed.Cylinder.Direction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShapeTest {
  private static final double[][] CENTRES = {
    {0, 0, 0}, {0.5, 0.5, 0.5}, {0.5, 0, 0.25}, {0.123, -0.41, 0.3337}, {1e-9, -1e-12, 0.499999}
  };

  /** Sum of the fractions of all cells of a cube when the shape stands at this centre. */
  private static double sum(Shape shape, double[] centre, int half) {
    double sum = 0;
    for (int z = -half; z <= half; z++) {
      for (int y = -half; y <= half; y++) {
        for (int x = -half; x <= half; x++) {
          double fraction = shape.fraction(x - centre[0], y - centre[1], z - centre[2]);
          assertTrue(fraction >= 0 && fraction <= 1, "fraction=" + fraction);
          sum += fraction;
        }
      }
    }
    return sum;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.2, 0.49, 0.7, 1, 2.5, 10})
  void fractionsOfASphereAddUpToItsVolumeWhereverItStands(double radius) {
    Sphere sphere = new Sphere(radius);
    for (double[] centre : CENTRES) {
      double sum = sum(sphere, centre, (int) radius + 2);
      assertEquals(1, sum / sphere.volume(), 1e-12, "rounding of " + centre[0]);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.2, 0.7, 3.3, 10})
  void fractionsOfACylinderAddUpToItsVolumeWhereverItStands(double radius) {
    for (Direction along : Direction.values()) {
      Cylinder cylinder = new Cylinder(along, radius, 2.3);
      for (double[] centre : CENTRES) {
        double sum = sum(cylinder, centre, (int) Math.max(radius, 2.3) + 2);
        assertEquals(1, sum / cylinder.volume(), 1e-12); // rounding
      }
    }
  }

  @Test
  void fractionsOfABoxAddUpToItsVolumeWhereverItStands() {
    Box box = new Box(2.4, 0.3, 5);
    for (double[] centre : CENTRES) {
      assertEquals(1, sum(box, centre, 7) / box.volume(), 1e-13); // rounding
    }
  }

  /** Counts the midpoints of n³ sub-cells. */
  private interface Inside {
    boolean at(double x, double y, double z);
  }

  private static double sampled(Inside inside, double x, double y, double z, int n) {
    int count = 0;
    for (int k = 0; k < n; k++) {
      for (int j = 0; j < n; j++) {
        for (int i = 0; i < n; i++) {
          if (inside.at(
              x + (i + 0.5) / n - 0.5, y + (j + 0.5) / n - 0.5, z + (k + 0.5) / n - 0.5)) {
            count++;
          }
        }
      }
    }
    return (double) count / n / n / n;
  }

  @Test
  void fractionsAreThoseOfSampledCells() {
    Random random = new Random(1998);
    for (int n = 0; n < 300; n++) {
      double radius = 0.3 + 3 * random.nextDouble();
      double x = (radius + 0.8) * (2 * random.nextDouble() - 1);
      double y = (radius + 0.8) * (2 * random.nextDouble() - 1);
      double z = (radius + 0.8) * (2 * random.nextDouble() - 1);
      double square = radius * radius;
      // 40³ midpoints: the cut ones, about 40², err by half a sub-cell at random
      assertEquals(
          sampled((a, b, c) -> a * a + b * b + c * c < square, x, y, z, 40),
          new Sphere(radius).fraction(x, y, z),
          3e-3);
      assertEquals(
          sampled((a, b, c) -> a * a + c * c < square && Math.abs(b) < 1, x, y, z, 40),
          new Cylinder(Direction.Y, radius, 1).fraction(x, y, z),
          1.5e-2); // the cylinder's ends lie along rows of midpoints
      HalfSpace half =
          new HalfSpace(
              random.nextGaussian(),
              random.nextGaussian() * Math.pow(10, -random.nextInt(9)),
              random.nextGaussian() * Math.pow(10, -random.nextInt(9)));
      assertEquals(
          sampled((a, b, c) -> half.nx() * a + half.ny() * b + half.nz() * c < 0, x, y, z, 40),
          half.fraction(x, y, z),
          1.3e-2); // and a plane may do so too
    }
  }

  /**
   * The inclusion-exclusion formula of Scardovelli and Zaleski (2000), where it keeps its digits.
   */
  @Test
  void halfSpaceAgreesWithTheClosedForm() {
    Random random = new Random(2000);
    for (int n = 0; n < 10_000; n++) {
      double a = 0.1 + random.nextDouble();
      double b = 0.1 + random.nextDouble();
      double c = 0.1 + random.nextDouble();
      double x = 2 * random.nextDouble() - 1;
      double depth = (a + b + c) / 2 - a * x;
      double volume = 0;
      for (int corner = 0; corner < 8; corner++) {
        double beyond = depth - (corner & 1) * a - (corner >> 1 & 1) * b - (corner >> 2) * c;
        double sign = Integer.bitCount(corner) % 2 == 0 ? 1 : -1;
        volume += beyond > 0 ? sign * beyond * beyond * beyond / (6 * a * b * c) : 0;
      }
      assertEquals(volume, new HalfSpace(a, -b, c).fraction(x, 0, 0), 1e-11); // 1/(6 * 0.1³) eps
    }
  }

  @Test
  void halfSpaceIsExactAlongTheAxesAndComplementsItsOpposite() {
    assertEquals(0.75, new HalfSpace(0, 2, 0).fraction(3, -0.25, 8), 0);
    assertEquals(0.25, new HalfSpace(0, 0, -1).fraction(3, -0.25, -0.25), 0);
    Random random = new Random(3);
    for (int n = 0; n < 10_000; n++) {
      double a = random.nextGaussian() * Math.pow(10, -random.nextInt(12));
      double b = random.nextGaussian() * Math.pow(10, -random.nextInt(12));
      double c = random.nextGaussian() * Math.pow(10, -random.nextInt(12));
      double x = random.nextDouble() - 0.5;
      double y = random.nextDouble() - 0.5;
      double one = new HalfSpace(a, b, c).fraction(x, y, 0.1);
      double other = new HalfSpace(-a, -b, -c).fraction(x, y, 0.1);
      assertEquals(1, one + other, 1e-14); // rounding, however small a component is
    }
  }

  @Test
  void smallShiftChangesTheFractionSmoothly() {
    Sphere sphere = new Sphere(10);
    double before = Double.NaN;
    double change = Double.NaN;
    for (double x = 8; x < 12; x += 1e-3) {
      double now = sphere.fraction(x, 0.3, -2.2);
      double nowChange = now - before;
      if (x > 8.0025) {
        // the fraction's slope is at most 1 and changes by a few per node of shift
        assertEquals(change, nowChange, 1e-5);
      }
      before = now;
      change = nowChange;
    }
  }

  @Test
  void greyValuesBecomeFractions() {
    byte[] grey = {0, 50, 100, (byte) 150, (byte) 200, (byte) 255};
    Coverage coverage = Coverage.ofGrey(3, 2, 1, grey, 50, 150);
    assertEquals(0, coverage.fraction(-1, -0.5, 0), 0);
    assertEquals(0, coverage.fraction(0, -0.5, 0), 0);
    assertEquals(0.5, coverage.fraction(1, -0.5, 0), 0);
    assertEquals(1, coverage.fraction(-1, 0.5, 0), 0);
    assertEquals(1, coverage.fraction(1, 0.5, 0), 0);
    assertEquals(0, coverage.fraction(2, 0.5, 0), 0);
    assertEquals(3.5, coverage.volume(), 0);
    for (double x = -1.75; x < 2; x += 0.25) { // images side by side: each place is in one
      int images = 0;
      Coverage solid = Coverage.of(3, 1, 1, new float[] {1, 1, 1});
      for (int image = -1; image <= 1; image++) {
        images += (int) solid.fraction(x + 3 * image, 0, 0);
      }
      assertEquals(1, images, "x=" + x);
    }
    Coverage inverse = Coverage.ofGrey(3, 2, 1, grey, 150, 50);
    assertEquals(2.5, inverse.volume(), 0);
  }

  @Test
  void refusesShapesWithoutVolume() {
    assertThrows(IllegalArgumentException.class, () -> new Sphere(0));
    assertThrows(IllegalArgumentException.class, () -> new Sphere(Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> new Box(1, -1, 1));
    assertThrows(IllegalArgumentException.class, () -> new Cylinder(Direction.X, 1, 0));
    assertThrows(IllegalArgumentException.class, () -> new HalfSpace(0, 0, 0));
    assertThrows(
        IllegalArgumentException.class, () -> Coverage.of(1, 1, 1, new float[] {Float.NaN}));
    assertThrows(IllegalArgumentException.class, () -> Coverage.of(2, 1, 1, new float[] {1}));
    assertThrows(
        IllegalArgumentException.class, () -> Coverage.ofGrey(1, 1, 1, new byte[] {1}, 7, 7));
  }
}
