package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Poiseuille flow between plates, where TRT at magic 3/16 is exact at the nodes. */
class ChannelValidationTest {
  private static final int WIDTH = 9;
  private static final double G = 1e-6;

  @ParameterizedTest
  @CsvSource({
    "D3Q15, LINEAR, 0.55",
    "D3Q15, LINEAR, 1",
    "D3Q15, LINEAR, 4",
    "D3Q19, LINEAR, 0.55",
    "D3Q19, LINEAR, 1",
    "D3Q19, LINEAR, 4",
    "D3Q15, QUADRATIC, 0.8",
    "D3Q19, QUADRATIC, 0.8"
  })
  void trtGivesTheParabolaAtEveryNodeAtAnyTau(VelocitySet set, Equilibrium form, double tau) {
    LbmScheme scheme = channel(set, form, Relaxation.trt(tau));
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = Flows.toSteadyState(dispatcher, scheme, 1e-11);
      double nu = scheme.relaxation().viscosity();
      double top = G * WIDTH * WIDTH / (8 * nu);
      scheme.forEachNode(
          (x, y, z, density, ux, uy, uz) -> {
            double fromWall = y + 0.5;
            double exact = G / (2 * nu) * fromWall * (WIDTH - fromWall);
            assertEquals(exact, ux, 1e-6 * top, "y=" + y);
            assertEquals(0, uy, 1e-6 * top);
            assertEquals(0, uz, 1e-6 * top);
          });
      double mean = Flows.sum(scheme, loop, u -> u[0]) / WIDTH;
      assertEquals(WIDTH * WIDTH / 12.0 + 1.0 / 24, mean * nu / G, 1e-5);
    }
  }

  @Test
  void bgkDriftsWithTau() {
    double k1 = permeability(Relaxation.bgk(1));
    double k2 = permeability(Relaxation.bgk(2));
    assertTrue(k2 > 1.05 * k1, "k(tau 1)=" + k1 + ", k(tau 2)=" + k2);
  }

  private static double permeability(Relaxation relaxation) {
    LbmScheme scheme = channel(VelocitySet.D3Q19, Equilibrium.LINEAR, relaxation);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = Flows.toSteadyState(dispatcher, scheme, 1e-9);
      return Flows.sum(scheme, loop, u -> u[0]) / WIDTH * relaxation.viscosity() / G;
    }
  }

  private static LbmScheme channel(VelocitySet set, Equilibrium form, Relaxation relaxation) {
    return LbmScheme.on(Flows.channel(WIDTH))
        .velocitySet(set)
        .equilibrium(form)
        .relaxation(relaxation)
        .force(new BodyForce(G, 0, 0))
        .build();
  }
}
