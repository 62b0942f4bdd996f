package org.hdispatch.sph.cases;

import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.sph.EquationOfState;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;

/**
 * A periodic box of one fluid in a shear flow, v_x = U sin(2 pi y/L): the case that speeds are
 * compared on. Particles start near a simple-cubic lattice; lengths are in its spacings, times in
 * steps.
 *
 * @param edge particles along an edge of the box
 * @param support support radius of the quintic spline
 */
public record PeriodicShear(int edge, double support) {
  /** Velocity amplitude: neighbour lists with a skin of 0.3 last about 10 steps. */
  private static final double AMPLITUDE = 0.015;

  private static final double SOUND_SPEED = 0.15;
  private static final double VISCOSITY = 0.01;
  private static final double JITTER = 0.05;
  private static final double SKIN = 0.3;
  private static final int SEED = 20;

  /**
   * Checks the size.
   *
   * @throws IllegalArgumentException if the box is shorter than twice the support
   */
  public PeriodicShear {
    if (edge < 2 * support) {
      throw new IllegalArgumentException(
          "edge of the box must be at least twice the support: edge="
              + edge
              + ", support="
              + support);
    }
  }

  /** Number of particles. */
  public int count() {
    return edge * edge * edge;
  }

  /** Settings of the scheme, of which the search and its cells may still be chosen. */
  public SphSchemeBuilder settings() {
    ParticleBox box =
        ParticleBox.space(edge, edge, edge, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
    return SphScheme.builder(box, new QuinticSpline(support / 3, 3))
        .phase(Phase.fluid("fluid", 1, VISCOSITY, EquationOfState.linear(1, SOUND_SPEED, 0)))
        .skin(SKIN)
        .timeStep(1);
  }

  /**
   * The same settings with an acceleration that upholds the flow against viscosity, nu (2 pi/L)^2
   * v_x: for long runs, as it otherwise dies away within some hundred steps.
   */
  public SphSchemeBuilder driven() {
    double wavenumber = 2 * Math.PI / edge;
    double strongest = VISCOSITY * wavenumber * wavenumber * AMPLITUDE;
    return settings()
        .accelerationField(
            (x, y, z, acceleration) -> {
              acceleration[0] = strongest * Math.sin(wavenumber * y);
              acceleration[1] = 0;
              acceleration[2] = 0;
            });
  }

  /** The particles. */
  public Particles particles() {
    Random random = new Random(SEED);
    Particles particles = new Particles();
    for (int k = 0; k < edge; k++) {
      for (int j = 0; j < edge; j++) {
        double u = AMPLITUDE * Math.sin(2 * Math.PI * (j + 0.5) / edge);
        for (int i = 0; i < edge; i++) {
          particles.add(0, place(i, random), place(j, random), place(k, random), u, 0, 0);
        }
      }
    }
    return particles;
  }

  private static double place(int n, Random random) {
    return n + 0.5 + JITTER * (2 * random.nextDouble() - 1);
  }
}
