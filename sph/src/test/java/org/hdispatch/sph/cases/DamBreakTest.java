package org.hdispatch.sph.cases;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.sph.SphScheme;
import org.junit.jupiter.api.Test;

class DamBreakTest {

  /** Not faster than a shallow wave over a dry bed, 2 sqrt(g H) (Ritter 1892); it begins slower. */
  @Test
  void frontRunsNoFasterThanAWaveOverADryBed() {
    DamBreak dam = new DamBreak(16);
    SphScheme scheme = dam.settings().build(dam.particles());
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      double begin = Flows.runTo(loop, scheme, 0.7 * dam.time());
      double from = dam.front(scheme);
      double end = Flows.runTo(loop, scheme, 1.3 * dam.time());
      double speed = (dam.front(scheme) - from) / (end - begin) * dam.time(); // over sqrt(g H)
      assertTrue(speed > 0.8 && speed < 2, () -> "speed=" + speed);
    }
    int[] fluid = new int[1];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          if (phase == 0) {
            fluid[0]++;
            assertTrue(x > 4 && y > 4, () -> "in the wall: " + x + ", " + y);
          }
        });
    assertEquals(16 * 16, fluid[0]);
  }
}
