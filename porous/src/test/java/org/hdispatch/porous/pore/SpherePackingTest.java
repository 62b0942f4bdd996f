package org.hdispatch.porous.pore;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class SpherePackingTest {

  /** The seven solid fractions of Zick and Homsy (1982) for simple cubic packing. */
  @ParameterizedTest
  @ValueSource(doubles = {0.027, 0.064, 0.125, 0.216, 0.343, 0.45, 0.5236})
  void simpleCubicIsTheBallInTheMiddle(double solidFraction) {
    int n = 32;
    double r2 = Math.pow(n * Math.cbrt(3 * solidFraction / (4 * Math.PI)), 2);
    PoreSpace space = SpherePacking.SC.poreSpace(n, solidFraction);
    int solid = 0;
    for (int z = 0; z < n; z++) {
      for (int y = 0; y < n; y++) {
        for (int x = 0; x < n; x++) {
          double dx = x + 0.5 - n / 2.0;
          double dy = y + 0.5 - n / 2.0;
          double dz = z + 0.5 - n / 2.0;
          boolean inside = dx * dx + dy * dy + dz * dz < r2;
          assertEquals(!inside, space.isPore(x, y, z));
          solid += inside ? 1 : 0;
        }
      }
    }
    // The staircase volume of the smallest ball (radius 6 voxels) is off by 3 to 4 %.
    assertEquals(solidFraction, solid / (double) (n * n * n), 0.04 * solidFraction);
  }

  /** All 27 images of every centre, one by one, against the nearest image. */
  @ParameterizedTest
  @EnumSource
  void periodicImagesAreIncluded(SpherePacking packing) {
    double[][] centres =
        switch (packing) {
          case SC -> new double[][] {{0.5, 0.5, 0.5}};
          case BCC -> new double[][] {{0.5, 0.5, 0.5}, {0, 0, 0}};
          case FCC -> new double[][] {{0.5, 0.5, 0.5}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}};
        };
    int n = 17; // odd, so that centres fall between and onto voxel centres
    double c = 0.5;
    double r = n * Math.cbrt(3 * c / (4 * Math.PI * centres.length));
    PoreSpace space = packing.poreSpace(n, c);
    for (int z = 0; z < n; z++) {
      for (int y = 0; y < n; y++) {
        for (int x = 0; x < n; x++) {
          boolean inside = false;
          for (double[] centre : centres) {
            for (int image = 0; image < 27; image++) {
              double dx = x + 0.5 - n * (centre[0] + image % 3 - 1);
              double dy = y + 0.5 - n * (centre[1] + image / 3 % 3 - 1);
              double dz = z + 0.5 - n * (centre[2] + image / 9 - 1);
              inside |= dx * dx + dy * dy + dz * dz < r * r;
            }
          }
          assertEquals(!inside, space.isPore(x, y, z));
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void theRadiusGivesTheSolidFraction(SpherePacking packing) {
    double r = packing.radius(10, 0.3);
    double volume = packing.spheresPerCell() * 4 * Math.PI / 3 * r * r * r;
    assertEquals(0.3, volume / 1000, 1e-14); // rounding of a cube root
  }

  @ParameterizedTest
  @EnumSource
  void atClosePackingTheSpheresTouch(SpherePacking packing) {
    double nearest =
        switch (packing) {
          case SC -> 1;
          case BCC -> Math.sqrt(3) / 2;
          case FCC -> Math.sqrt(2) / 2;
        };
    assertEquals(nearest / 2, packing.radius(1, packing.closePacking()), 1e-15);
  }

  @Test
  void roundedClosePackingPassesAndOverlapDoesNot() {
    assertTrue(SpherePacking.SC.poreSpace(8, 0.5236).poreVoxels() > 0);
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> SpherePacking.SC.poreSpace(8, 0.524));
    assertTrue(e.getMessage().startsWith("spheres must not overlap"), e.getMessage());
    assertTrue(e.getMessage().contains("limit=0.52359"), e.getMessage());
    assertThrows(IllegalArgumentException.class, () -> SpherePacking.BCC.poreSpace(8, 0.681));
    assertThrows(IllegalArgumentException.class, () -> SpherePacking.FCC.poreSpace(8, 0.741));
  }

  @Test
  void solidFractionsThatAreNoneAreRefused() {
    for (double c : new double[] {0, 1, -0.1, 2, Double.NaN}) {
      assertThrows(IllegalArgumentException.class, () -> SpherePacking.SC.poreSpace(8, c));
    }
    assertThrows(IllegalArgumentException.class, () -> SpherePacking.SC.poreSpace(0, 0.3));
  }
}
