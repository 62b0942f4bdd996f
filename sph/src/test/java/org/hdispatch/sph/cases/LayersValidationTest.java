package org.hdispatch.sph.cases;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.ViscosityMean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Two fluids of unlike density and viscosity side by side. */
class LayersValidationTest {
  private static final int ACROSS = 10;

  /** The velocity has a kink at the interface. Found: 0.6 and 0.5 % of the greatest velocity. */
  @ParameterizedTest
  @CsvSource({"HARMONIC, 1e-2", "ARITHMETIC, 1e-2"})
  void layersFlowAsTheTwoParabolasDo(ViscosityMean mean, double allowed) {
    LayeredPoiseuille flow = new LayeredPoiseuille(ACROSS, 2, 4);
    SphScheme scheme = flow.settings().viscosityMean(mean).build(flow.particles());
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      dispatcher.loop(scheme).run((long) (flow.settlingTime() / scheme.timeStep()));
    }
    double[] sums = new double[3];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          if (phase < 2) {
            double apart = u - flow.velocity(y);
            sums[0] += apart * apart;
            sums[1]++;
            sums[2] = Math.max(sums[2], flow.velocity(y));
          }
        });
    assertEquals(0, Math.sqrt(sums[0] / sums[1]) / sums[2], allowed);
  }

  /** Each fluid sticks to any wall as to its own; the densities of these fluids are one. */
  @ParameterizedTest
  @EnumSource(ViscosityMean.class)
  void wallHasTheViscosityOfTheFluidThatTouchesIt(ViscosityMean mean) {
    LayeredPoiseuille flow = new LayeredPoiseuille(ACROSS, 1, 4);
    SphSchemeBuilder settings = flow.settings().viscosityMean(mean);
    double[][] velocities = new double[2][flow.particles().count()];
    for (int swapped = 0; swapped < 2; swapped++) {
      Particles particles = flow.particles();
      Particles walled = new Particles();
      for (int n = 0; n < particles.count(); n++) {
        int phase = particles.phase(n);
        int other = phase < 2 || swapped == 0 ? phase : 5 - phase;
        walled.add(other, particles.x(n), particles.y(n), particles.z(n));
      }
      SphScheme scheme = settings.build(walled);
      try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
        dispatcher.loop(scheme).run(50);
      }
      double[] along = velocities[swapped];
      scheme.forEachParticle((id, phase, x, y, z, u, v, w, n, p) -> along[id] = u);
    }
    assertArrayEquals(velocities[0], velocities[1]);
  }

  /** Alike, the layers are one: F s (L - s)/(2 nu), and its slope. */
  @Test
  void profileOfLikeLayersIsOneParabola() {
    LayeredPoiseuille flow = new LayeredPoiseuille(ACROSS, 1, 1);
    double force = 1e-4;
    for (double s = 0; s <= 2 * ACROSS; s += 0.5) {
      assertEquals(force * s * (2 * ACROSS - s) / 2, flow.velocity(s + 4), 1e-15);
    }
  }

  @Test
  void profileOfUnlikeLayersHasOneVelocityAndOneStress() {
    LayeredPoiseuille flow = new LayeredPoiseuille(ACROSS, 2, 4);
    double middle = 4 + ACROSS;
    double step = 1e-5;
    double below = flow.velocity(middle) - flow.velocity(middle - step);
    double above = flow.velocity(middle + step) - flow.velocity(middle);
    assertEquals(flow.velocity(middle - 1e-9), flow.velocity(middle), 1e-12);
    assertEquals(below, 4 * above, 1e-12); // of 1e-5 times a slope of 1e-4; curvature
    assertEquals(0, flow.velocity(4), 1e-15);
    assertEquals(0, flow.velocity(4 + 2 * ACROSS), 1e-15);
  }

  /** Without surface tension nothing drives a drop of another density; on a lattice it stays. */
  @ParameterizedTest
  @CsvSource({"2", "0.5"})
  void dropOfAnotherDensityRests(double densityRatio) {
    TwoPhaseDrop drop = new TwoPhaseDrop(10, densityRatio, 0, 0);
    SphScheme scheme = drop.settings().build(drop.particles());
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      for (int run = 0; run < 100; run++) {
        loop.run(10);
        assertTrue(scheme.fastest() < 1e-3 * drop.soundSpeed(), () -> "" + scheme.fastest());
      }
    }
  }

  /** Begun in disorder, it has come to rest by then: found 4.4e-4 c. */
  @Test
  void dropOfTwiceTheDensityComesToRest() {
    TwoPhaseDrop drop = new TwoPhaseDrop(10, 2, 0, 0.1);
    SphScheme scheme = drop.settings().build(drop.particles());
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      dispatcher.loop(scheme).run(1000);
    }
    assertTrue(scheme.fastest() < 1e-3 * drop.soundSpeed(), () -> "" + scheme.fastest());
  }
}
