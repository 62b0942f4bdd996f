package org.hdispatch.sph.cases;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.sph.SphScheme;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Drops held together by pairwise forces, in 2-D. The surface tension of the mean field, which the
 * strengths are made for, is 1.
 */
class DropValidationTest {
  private static final double[] RADII = {8, 12, 16, 20};

  /** Stress that stays frozen in drops, which are crystals: 1 % of the pressure of cohesion. */
  private static final double OFFSET = 0.021;

  /** Mean pressure in the inner part of a drop, over time, from when it has come to rest. */
  private static double pressure(Drop drop, double time, int samples) {
    SphScheme scheme = drop.settings().build(drop.particles());
    double sum = 0;
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      Flows.runTo(loop, scheme, time / 2);
      for (int sample = 1; sample <= samples; sample++) {
        Flows.runTo(loop, scheme, time / 2 * (1 + (double) sample / samples));
        sum += drop.pressure(scheme);
      }
    }
    return sum / samples;
  }

  /** Single drops of radius 8 to 20 are 11 to 39 % below Laplace's law: found -0.009 here. */
  @Test
  void pressureOfADropIsThatOfLaplaceButForFrozenStress() {
    Drop drop = Drop.firm(2, 12);
    SphScheme scheme = drop.settings().build(drop.particles());
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      Flows.runTo(dispatcher.loop(scheme), scheme, 300);
    }
    double known = drop.laplacePressure(scheme.particles());
    assertEquals(1.0 / 12, known, 0.01 / 12); // sites within the radius
    assertEquals(known, drop.pressure(scheme), OFFSET);
  }

  @Test
  void ballHasTwiceThePressureOfADisc() {
    Drop ball = Drop.firm(3, 10);
    assertEquals(2.0 / 10, ball.laplacePressure(ball.particles().count()), 0.02 / 10); // sites
  }

  /** Pressures follow a straight line in 1/R. Its slope is the surface tension. */
  @Test
  @Tag("validation")
  void pressureFollowsLaplace() {
    double[] curvatures = new double[RADII.length];
    double[] pressures = new double[RADII.length];
    double meanCurvature = 0;
    double meanPressure = 0;
    for (int n = 0; n < RADII.length; n++) {
      Drop drop = Drop.firm(2, RADII[n]);
      curvatures[n] = drop.laplacePressure(drop.particles().count());
      pressures[n] = pressure(drop, 300, 60);
      meanCurvature += curvatures[n] / RADII.length;
      meanPressure += pressures[n] / RADII.length;
    }
    double product = 0;
    double square = 0;
    for (int n = 0; n < RADII.length; n++) {
      double apart = curvatures[n] - meanCurvature;
      product += apart * (pressures[n] - meanPressure);
      square += apart * apart;
    }
    double tension = product / square;
    StringBuilder found = new StringBuilder("sigma=" + tension);
    double worst = 0;
    for (int n = 0; n < RADII.length; n++) {
      double line = meanPressure + tension * (curvatures[n] - meanCurvature);
      worst = Math.max(worst, Math.abs(pressures[n] - line));
      found.append(", R=").append(1 / curvatures[n]).append(": ").append(pressures[n]);
    }
    assertEquals(1, tension, 0.1, found::toString); // found: 1.00
    assertEquals(0, meanPressure - tension * meanCurvature, OFFSET, found::toString);
    // found: 6 % of the greatest; stress stays frozen in the drops, which are crystals
    assertEquals(0, worst / pressures[0], 0.08, found::toString);
  }

  /** A drop drawn out a little oscillates with Rayleigh's period. */
  @Test
  @Tag("validation")
  void drawnOutDropOscillates() {
    Drop drop = Drop.liquid(2, 12, 0.1, 1.3);
    SphScheme scheme = drop.settings().build(drop.particles());
    double expected = drop.period(1);
    double[] crossings = new double[3];
    int found = 0;
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      double last = elongation(scheme);
      double lastTime = 0;
      for (int sample = 1; found < crossings.length && sample < 200; sample++) {
        double time = Flows.runTo(loop, scheme, sample * expected / 50);
        double now = elongation(scheme);
        if (last * now < 0) {
          crossings[found++] = lastTime + (time - lastTime) * last / (last - now);
        }
        last = now;
        lastTime = time;
      }
    }
    assertEquals(3, found);
    assertEquals(1, (crossings[2] - crossings[0]) / expected, 0.1); // found: 1.07
  }

  /** Mean square of x over that of y about the middle, as (a - b)/(a + b). */
  private static double elongation(SphScheme scheme) {
    double[] sums = new double[5];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          sums[0]++;
          sums[1] += x;
          sums[2] += y;
          sums[3] += x * x;
          sums[4] += y * y;
        });
    double x = sums[1] / sums[0];
    double y = sums[2] / sums[0];
    double along = sums[3] / sums[0] - x * x;
    double across = sums[4] / sums[0] - y * y;
    return (along - across) / (along + across);
  }
}
