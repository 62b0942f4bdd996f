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
  private static final double ROUNDED = 0.5001e-6; // to the digits given

  // Sums computed apart from this code, by other forms of the kernels.
  @ParameterizedTest(name = "{0} h={1} dx")
  @CsvSource({
    "QUINTIC,  1.0, 24,  92, 1.000063, 0.999980, 1.000732, 1.001021",
    "QUINTIC,  1.2, 36, 178, 0.999944, 1.000006, 0.999436, 0.999064",
    "QUINTIC,  1.5, 68, 388, 1.000155, 1.000077, 1.000002, 1.000337",
    "CUBIC,    1.0,  8,  26, 1.000862, 0.999972, 1.012227, 1.020070",
    "CUBIC,    1.2, 20,  56, 0.999757, 1.000810, 0.991034, 0.980894",
    "CUBIC,    1.3, 20,  80, 0.999947, 0.997262, 1.010597, 0.996211",
    "WENDLAND, 1.0,  8,  26, 1.037602, 1.033843, 0.940853, 0.950149",
    "WENDLAND, 1.3, 20,  80, 1.010473, 1.009501, 0.963827, 0.969683",
    "WENDLAND, 1.5, 24,  92, 1.005142, 1.003141, 0.992297, 0.997486",
  })
  void latticeSumsAreThoseOfTheTable(
      Form form,
      double smoothingLength,
      int neighbours2d,
      int neighbours3d,
      double density2d,
      double density3d,
      double laplacian2d,
      double laplacian3d) {
    LatticeSum plane = LatticeSum.of(form.of(smoothingLength, 2), 1);
    LatticeSum space = LatticeSum.of(form.of(smoothingLength, 3), 1);
    assertEquals(neighbours2d, plane.neighbours());
    assertEquals(neighbours3d, space.neighbours());
    assertEquals(density2d, plane.numberDensity(), ROUNDED);
    assertEquals(density3d, space.numberDensity(), ROUNDED);
    assertEquals(laplacian2d, plane.laplacianFactor(), ROUNDED);
    assertEquals(laplacian3d, space.laplacianFactor(), ROUNDED);
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
