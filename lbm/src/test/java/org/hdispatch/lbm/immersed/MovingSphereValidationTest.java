package org.hdispatch.lbm.immersed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.DoubleSummaryStatistics;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Relaxation;
import org.hdispatch.lbm.VelocitySet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * A sphere, 20 nodes across, at Reynolds number 6 in a periodic box: moved through fluid without
 * mean flux, or held in the opposite flow.
 */
@Tag("validation")
class MovingSphereValidationTest {
  private static final int N = 36;
  private static final Sphere SPHERE = new Sphere(10);
  private static final double SPEED = 0.01;
  private static final double MIDDLE = (N - 1) / 2.0;

  @Test
  void movedAndHeldSphereFeelTheSameDragAndTheMovedOneSmoothly() {
    DoubleSummaryStatistics held = drag(false, 4_000, 100);
    DoubleSummaryStatistics moved = drag(true, 4_000, 1_000); // ten nodes
    assertEquals(1, moved.getAverage() / held.getAverage(), 0.002); // found: 3e-4
    double fluctuation = (moved.getMax() - moved.getMin()) / moved.getAverage();
    assertTrue(fluctuation < 0.003, "fluctuation=" + fluctuation); // found: 1e-3, part of it decay
    assertEquals(0.2004, held.getAverage(), 2e-4); // as found
  }

  /** Drag after a number of steps, under a body force of minus the drag over the fluid's volume. */
  private static DoubleSummaryStatistics drag(boolean moving, int before, int during) {
    Point middle = new Point(MIDDLE, MIDDLE, MIDDLE);
    Point velocity = new Point(SPEED, 0, 0);
    Body body =
        moving
            ? Body.prescribed(SPHERE, Path.straight(middle, velocity, Point.ZERO))
            : Body.fixed(SPHERE, middle);
    ImmersedBodies bodies = ImmersedBodies.of(body);
    LbmScheme scheme =
        LbmScheme.on(ImmersedFlows.periodic(N, N, N))
            .velocitySet(VelocitySet.D3Q15)
            .relaxation(Relaxation.bgk(0.6))
            .immersion(bodies)
            .build();
    double cells = N * N * N;
    double outside = -SPEED * cells / (cells - SPHERE.volume()); // seen from the sphere
    scheme.initialise(
        (x, y, z, state) ->
            state.ux =
                (moving ? SPEED : 0)
                    + outside * (1 - SPHERE.fraction(x - MIDDLE, y - MIDDLE, z - MIDDLE)));
    DoubleSummaryStatistics drag = new DoubleSummaryStatistics();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      for (int step = 0; step < before + during; step++) {
        loop.run(1);
        scheme.drive(new BodyForce(body.fx() / bodies.drivenVolume(), 0, 0));
        if (step >= before) {
          drag.accept(-body.fx());
        }
      }
      double flux = ImmersedFlows.momentum(scheme) / cells / SPEED;
      assertEquals(moving ? 0 : -1, flux, 2e-3); // the force comes a step late: one step's drag
    }
    return drag;
  }
}
