package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A decaying vortex: kinetic energy falls as exp(-4 nu k² t). */
class TaylorGreenValidationTest {
  private static final int N = 64;
  private static final double SPEED = 0.005;

  @ParameterizedTest
  @CsvSource({"D3Q15, TRT, 0.6", "D3Q15, BGK, 0.8", "D3Q19, TRT, 0.6", "D3Q19, BGK, 0.8"})
  void decayGivesTheViscosity(VelocitySet set, String collision, double tau) {
    LbmScheme scheme =
        LbmScheme.on(Lattice.empty(N, N, 1, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC))
            .velocitySet(set)
            .relaxation(collision.equals("TRT") ? Relaxation.trt(tau) : Relaxation.bgk(tau))
            .equilibrium(Equilibrium.QUADRATIC)
            .build();
    double wave = 2 * Math.PI / N;
    scheme.initialise(
        (x, y, z, state) -> {
          state.ux = SPEED * Math.sin(wave * x) * Math.cos(wave * y);
          state.uy = -SPEED * Math.cos(wave * x) * Math.sin(wave * y);
          double squares = Math.cos(2 * wave * x) + Math.cos(2 * wave * y);
          state.density = 1 + 0.75 * SPEED * SPEED * squares;
        });
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      loop.run(400); // the start, without its non-equilibrium part, dies out
      double before = energy(scheme, loop);
      int steps = 600;
      loop.run(steps);
      double after = energy(scheme, loop);
      double measured = Math.log(before / after) / (4 * wave * wave * steps);
      assertEquals(1, measured / scheme.relaxation().viscosity(), 1e-3); // O((k dx)²) = 1e-2 * 1/12
    }
  }

  private static double energy(LbmScheme scheme, TimeLoop loop) {
    return Flows.sum(scheme, loop, u -> u[0] * u[0] + u[1] * u[1]);
  }
}
