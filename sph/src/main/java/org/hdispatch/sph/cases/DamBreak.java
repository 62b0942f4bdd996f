package org.hdispatch.sph.cases;

import java.util.List;
import org.hdispatch.cell.Ends;
import org.hdispatch.sph.EquationOfState;
import org.hdispatch.sph.LatticeSum;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SmoothingKernel;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.TimeStep;
import org.hdispatch.sph.WallDistance;

/**
 * A square column of fluid, phase 0, that collapses in a tank four times as long, phase 1: 2-D,
 * free surface. Lengths in spacings, masses in those of a particle.
 *
 * @param height particles along an edge of the column
 */
public record DamBreak(int height) {
  private static final double GRAVITY = 1;
  private static final double MACH = 0.1; // of the fastest flow, sqrt(2 g H)
  private static final double DAMPING = 0.01; // kinematic viscosity over c h
  private static final int LAYERS = ViscousFlow.LAYERS;
  private static final int LENGTH = 4; // heights

  /**
   * Checks the size.
   *
   * @throws IllegalArgumentException if the column is less than 8 particles high
   */
  public DamBreak {
    if (height < 8) {
      throw new IllegalArgumentException(
          "column must be at least 8 particles high: height=" + height);
    }
  }

  /** Time that a shallow-water wave takes along the height of the column: sqrt(H/g). */
  public double time() {
    return Math.sqrt(height / GRAVITY);
  }

  private double soundSpeed() {
    return Math.sqrt(2 * GRAVITY * height) / MACH;
  }

  /** Settings of the scheme. */
  public SphSchemeBuilder settings() {
    SmoothingKernel kernel = new QuinticSpline(1, 2);
    double rest = LatticeSum.of(kernel, 1).numberDensity();
    EquationOfState state = EquationOfState.linear(1, soundSpeed(), 0);
    Phase fluid =
        Phase.fluid(
            "fluid", 1 / rest, DAMPING * soundSpeed(), EquationOfState.withoutTension(state));
    ParticleBox box =
        ParticleBox.plane(LENGTH * height + 2 * LAYERS, 2 * height + LAYERS, Ends.OPEN, Ends.OPEN);
    return SphScheme.builder(box, kernel)
        .phase(fluid)
        .phase(Phase.wallOf(fluid))
        .walls(walls())
        .bodyForce(0, -GRAVITY, 0)
        .timeStep(TimeStep.of(kernel, List.of(fluid), GRAVITY).allowed());
  }

  /** A tank without a lid. */
  private WallDistance walls() {
    double length = LENGTH * height;
    return (x, y, z) -> {
      double outX = Math.max(LAYERS - x, x - LAYERS - length);
      double outY = LAYERS - y;
      return outX > 0 && outY > 0 ? -Math.hypot(outX, outY) : -Math.max(outX, outY);
    };
  }

  /** The particles, at rest on a lattice that the weight has pressed together. */
  public Particles particles() {
    Particles particles = new Particles();
    WallDistance walls = walls();
    double compression = GRAVITY / (soundSpeed() * soundSpeed());
    for (int j = 0; j < 2 * height + LAYERS; j++) {
      for (int i = 0; i < LENGTH * height + 2 * LAYERS; i++) {
        double x = i + 0.5;
        double y = j + 0.5;
        double up = y - LAYERS;
        if (walls.at(x, y, 0) <= 0) {
          particles.add(1, x, y, 0);
        } else if (x < LAYERS + height && up < height) {
          particles.add(0, x, y - compression * up * (height - up / 2), 0);
        }
      }
    }
    return particles;
  }

  /** How far the fluid has come, from the wall behind it, over the height of the column. */
  public double front(SphScheme scheme) {
    double[] farthest = new double[1];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) ->
            farthest[0] = phase == 0 ? Math.max(farthest[0], x - LAYERS) : farthest[0]);
    return farthest[0] / height;
  }
}
