package org.hdispatch.sph.cases;

import org.hdispatch.sph.ParticleLattice;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.WallDistance;

/**
 * Water between two plane walls, set in motion by a body force (Morris, Fox, Zhu 1997, 4.2): 2-D,
 * gap 1e-3 m, force 2e-4 m/s2, Re 0.025. Lengths in m, times in s.
 *
 * @param across particles across the gap
 * @param disorder of the particles to begin with, in spacings: 0 is a lattice
 */
public record Poiseuille(int across, double disorder) implements FlowCase {
  /** Distance L of the walls, m. */
  public static final double GAP = 1e-3;

  /** Kinematic viscosity nu, m2/s. */
  public static final double VISCOSITY = 1e-6;

  /** Body force F, m/s2. */
  public static final double FORCE = 2e-4;

  /** Velocity in the middle, F L^2/(8 nu), that of the steady flow, m/s. */
  public static final double GREATEST = FORCE * GAP * GAP / (8 * VISCOSITY);

  private static final double DENSITY = 1000;
  private static final double SOUND_SPEED = 2.5e-4;
  private static final int LENGTH = 10; // of the box, in spacings
  private static final int TERMS = 200;

  /**
   * Checks the number of particles.
   *
   * @throws IllegalArgumentException if there are fewer than 4
   */
  public Poiseuille {
    Slit.check(across);
  }

  @Override
  public ParticleLattice lattice() {
    return Slit.lattice(GAP, across, LENGTH);
  }

  /** Place along y of the lower wall. */
  public double lowerWall() {
    return Slit.low(GAP, across);
  }

  @Override
  public WallDistance walls() {
    return Slit.walls(GAP, across);
  }

  private ViscousFlow flow() {
    return new ViscousFlow(lattice(), walls(), DENSITY, VISCOSITY, FORCE, SOUND_SPEED);
  }

  @Override
  public SphSchemeBuilder settings() {
    return flow().settings();
  }

  @Override
  public Particles particles() {
    return flow().particles(disorder);
  }

  /**
   * Velocity of the exact solution (Morris et al. 1997, eq. 21).
   *
   * @param height above the lower wall, 0 to L
   * @param time since the force began
   */
  public static double velocity(double height, double time) {
    double sum = 0;
    for (int n = TERMS - 1; n >= 0; n--) { // small terms first
      double wave = (2 * n + 1) * Math.PI / GAP;
      double part = 4 * FORCE / (VISCOSITY * GAP * wave * wave * wave);
      sum += part * Math.sin(wave * height) * Math.exp(-wave * wave * VISCOSITY * time);
    }
    return FORCE / (2 * VISCOSITY) * height * (GAP - height) - sum;
  }
}
