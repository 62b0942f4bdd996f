package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * What each kernel makes of a square or simple-cubic lattice of spacing dx = 1.
 *
 * <p>Number density: {@code n = sum_j W(r_j)}, the particle itself included; exact would be 1.
 *
 * <p>Laplacian factor (effective over true viscosity): Morris' viscous term (Morris, Fox, Zhu
 * 1997), {@code (1/m) sum_j (2 mu / n^2) (v_i - v_j) W'(r_j)/r_j}, applied to the quadratic
 * velocity field {@code v = |r|^2} about particle i and divided by the true {@code (mu / (m n)) 2
 * d}. With v_i = 0 and v_j = r_j^2 this leaves
 *
 * <pre>
 * factor = -(1/(d n)) sum_j r_j W'(r_j)
 * </pre>
 *
 * with n the lattice sum above, not 1/dx^d, and d the number of dimensions.
 */
class LatticeSumTest {

  // Computed independently of this code (project notes, table of kernels); to the digits given.
  @ParameterizedTest(name = "{0} h={1} dx")
  @CsvSource({
    "QUINTIC,  1.0, 24,  92, 1.00006, 0.99998, 1.00073, 1.00102",
    "QUINTIC,  1.2, 36, 178, 0.99994, 1.00001, 0.99944, 0.99906",
    "QUINTIC,  1.5, 68, 388, 1.00016, 1.00008, 1.00000, 1.00034",
    "CUBIC,    1.0,  8,  26, 1.00086, 0.99997, 1.012,   1.020",
    "CUBIC,    1.2, 20,  56, 0.99976, 1.00081, 0.991,   0.981",
    "CUBIC,    1.3, 20,  80, 0.99995, 0.99726, 1.0106,  0.9962",
    "WENDLAND, 1.0,  8,  26, 1.038,   1.034,   0.941,   0.950",
    "WENDLAND, 1.3, 20,  80, 1.0105,  1.0095,  0.964,   0.970",
    "WENDLAND, 1.5, 24,  92, 1.0051,  1.0031,  0.992,   0.9975",
  })
  void latticeSumsAreThoseOfTheTable(
      Form form,
      double smoothingLength,
      int neighbours2d,
      int neighbours3d,
      String density2d,
      String density3d,
      String laplacian2d,
      String laplacian3d) {
    LatticeSum plane = LatticeSum.of(form.of(smoothingLength, 2), 1);
    LatticeSum space = LatticeSum.of(form.of(smoothingLength, 3), 1);
    assertEquals(neighbours2d, plane.neighbours());
    assertEquals(neighbours3d, space.neighbours());
    assertEqualToTheDigitsGiven(density2d, plane.numberDensity());
    assertEqualToTheDigitsGiven(density3d, space.numberDensity());
    assertEqualToTheDigitsGiven(laplacian2d, plane.laplacianFactor());
    assertEqualToTheDigitsGiven(laplacian3d, space.laplacianFactor());
  }

  private static void assertEqualToTheDigitsGiven(String expected, double actual) {
    int decimals = expected.length() - expected.indexOf('.') - 1;
    assertEquals(Double.parseDouble(expected), actual, 0.5001 * Math.pow(10, -decimals));
  }

  private enum Form {
    QUINTIC,
    CUBIC,
    WENDLAND;

    SmoothingKernel of(double smoothingLength, int dimensions) {
      return switch (this) {
        case QUINTIC -> new QuinticSpline(smoothingLength, dimensions);
        case CUBIC -> new CubicSpline(smoothingLength, dimensions);
        case WENDLAND -> new WendlandC2(smoothingLength, dimensions);
      };
    }
  }
}
