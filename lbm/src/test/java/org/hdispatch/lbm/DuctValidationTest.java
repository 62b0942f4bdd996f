package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The square duct of Leonardi et al. 2011, Figure 4. */
class DuctValidationTest {
  /** k/W² of a square duct from the series solution (White, Viscous Fluid Flow, 3-48). */
  private static final double EXACT = 0.0351442537;

  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void permeabilityConvergesAtSecondOrder(VelocitySet set) {
    double e8 = permeability(set, 8) / EXACT - 1;
    double e16 = permeability(set, 16) / EXACT - 1;
    double e32 = permeability(set, 32) / EXACT - 1;
    // Half the spacing leaves a quarter of the error: log2 of the ratio is the order, 2 but for the
    // corners.
    assertEquals(2, Math.log(e8 / e16) / Math.log(2), 0.1, e8 + " " + e16 + " " + e32);
    assertEquals(2, Math.log(e16 / e32) / Math.log(2), 0.1, e8 + " " + e16 + " " + e32);
    if (set == VelocitySet.D3Q15) { // the figures of docs/validation.md
      assertEquals(0.0223, e8, 5e-5);
      assertEquals(0.0058, e16, 5e-5);
      assertEquals(0.0015, e32, 5e-5);
    }
  }

  /** Deviations from the weights are small numbers: 24 bits of them are enough. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void storageInSinglePrecisionHardlyShows(VelocitySet set) {
    for (int width : new int[] {8, 16}) {
      double exact = permeability(set, width, Storage.DOUBLE);
      // 2^-24 = 6e-8 a step and population, of either sign.
      assertEquals(1, permeability(set, width, Storage.SINGLE) / exact, 2e-6);
    }
  }

  private static double permeability(VelocitySet set, int width) {
    return permeability(set, width, Storage.DOUBLE);
  }

  private static double permeability(VelocitySet set, int width, Storage storage) {
    double g = 1e-6;
    LbmScheme scheme =
        LbmScheme.on(Flows.duct(width))
            .velocitySet(set)
            .storage(storage)
            .equilibrium(Equilibrium.LINEAR)
            .relaxation(Relaxation.trt(2))
            .force(new BodyForce(g, 0, 0))
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = Flows.toSteadyState(dispatcher, scheme, 1e-8);
      double mean = Flows.sum(scheme, loop, u -> u[0]) / width / width;
      return mean * scheme.relaxation().viscosity() / g / width / width;
    }
  }
}
