package org.hdispatch.lbm.immersed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.immersed.SettlingSphere.Fluid;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class SettlingSphereValidationTest {
  /** Sphere 8 nodes across. Found: -2.0, +1.8, +0.3, -1.9 % for the four fluids. */
  @Tag("validation")
  @Test
  void peakVelocityInTheThinnestFluidIsTheMeasuredOne() {
    SettlingSphere settling = new SettlingSphere(Fluid.E4, 53);
    double[] peak = new double[1];
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(settling.scheme());
      loop.runUntil(
          tick -> {
            peak[0] = Math.max(peak[0], settling.velocity());
            return settling.velocity() < 0.97 * peak[0];
          },
          (long) (1.2 / settling.timeStep()));
    }
    assertEquals(1, peak[0] / Fluid.E4.peak(), 0.05);
    assertTrue(settling.gap() > 0 && settling.gap() < 0.03, "gap=" + settling.gap() + " m");
  }

  @Test
  void sphereFallsAndMachNumberStaysSmall() {
    for (Fluid fluid : Fluid.values()) {
      SettlingSphere settling = new SettlingSphere(fluid, 20);
      try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
        dispatcher.loop(settling.scheme()).run(200);
      }
      assertTrue(settling.velocity() > 0, fluid.name());
      double atPeak = -settling.sphere().uz() / settling.velocity() * fluid.peak();
      assertTrue(atPeak < 0.05 / Math.sqrt(3) + 1e-12, fluid.name());
      assertTrue(settling.scheme().relaxation().relaxationTime() < 0.6 + 1e-12, fluid.name());
    }
  }
}
