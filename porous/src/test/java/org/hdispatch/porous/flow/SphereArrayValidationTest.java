package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.porous.pore.SpherePacking;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Stokes flow through a simple cubic array of spheres. */
@Tag("validation")
class SphereArrayValidationTest {
  private static final FlowOptions PERIODIC =
      FlowOptions.DEFAULT.withBoundaries(Sides.PERIODIC, Inlet.PERIODIC);

  /**
   * The error against Zick and Homsy (J. Fluid Mech. 115, 1982, 13, Table 2) is that of the
   * staircase surface, the same in every code with binary voxels and half-way bounce-back: the
   * reference errors come from an independent code. Measured at 32³.
   */
  @ParameterizedTest
  @CsvSource({
    "0.027, 2.008, -2.67, -3.01",
    "0.064, 2.810, -4.73, -4.74",
    "0.125, 4.292, -0.21, -0.36",
    "0.216, 7.442, -2.69, -2.78",
    "0.343, 15.4, -4.07, -3.99",
    "0.45, 28.1, -5.53, -5.21",
    "0.5236, 42.1, -4.98, -4.68"
  })
  void staircaseErrorsAreThoseOfBinaryVoxels(
      double solidFraction, double drag, double errorD3Q15, double errorD3Q19) {
    int n = 32;
    double radius = Math.cbrt(3 * solidFraction / (4 * Math.PI));
    double exact = n * n / (6 * Math.PI * drag * radius); // k = L³ / (6 pi a K)
    PoreSpace spheres = SpherePacking.SC.poreSpace(n, solidFraction);
    double d3q15 = permeability(spheres, PERIODIC.withVelocitySet(VelocitySet.D3Q15), 1e-5);
    double d3q19 = permeability(spheres, PERIODIC.withVelocitySet(VelocitySet.D3Q19), 1e-5);
    assertEquals(errorD3Q15, 100 * (d3q15 / exact - 1), 0.1, "D3Q15, percent");
    assertEquals(errorD3Q19, 100 * (d3q19 / exact - 1), 0.1, "D3Q19, percent");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.125, 0.343})
  void permeabilityDoesNotDependOnTau(double solidFraction) {
    PoreSpace spheres = SpherePacking.SC.poreSpace(24, solidFraction);
    double reference = permeability(spheres, PERIODIC.withRelaxationTime(1), 1e-6);
    for (double tau : new double[] {0.6, 2, 4, 8}) {
      double k = permeability(spheres, PERIODIC.withRelaxationTime(tau), 1e-6);
      assertEquals(1, k / reference, 1e-4, "tau=" + tau);
    }
  }

  private static double permeability(PoreSpace space, FlowOptions options, double tolerance) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      SteadyFlow flow =
          LbmFlow.solve(dispatcher, space, options.withTolerance(tolerance), FlowListener.NONE);
      assertTrue(flow.converged());
      return flow.permeability();
    }
  }
}
