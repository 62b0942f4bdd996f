package org.hdispatch.sph.cases;

import org.hdispatch.sph.ParticleLattice;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.WallDistance;

/**
 * Water between two plane walls of which the upper one is set in motion (Morris, Fox, Zhu 1997,
 * 4.1): 2-D, gap 1e-3 m, velocity 1.25e-5 m/s, Re 0.0125. Particles of the wall stay where they are
 * and carry its velocity.
 *
 * @param across particles across the gap
 * @param disorder of the particles to begin with, in spacings: 0 is a lattice
 */
public record Couette(int across, double disorder) implements FlowCase {
  /** Distance L of the walls, m. */
  public static final double GAP = 1e-3;

  /** Kinematic viscosity nu, m2/s. */
  public static final double VISCOSITY = 1e-6;

  /** Velocity V of the upper wall, m/s. */
  public static final double WALL_VELOCITY = 1.25e-5;

  private static final double DENSITY = 1000;
  private static final double SOUND_SPEED = 2.5e-4;
  private static final int LENGTH = 10; // of the box, in spacings
  private static final int TERMS = 400;

  /**
   * Checks the number of particles.
   *
   * @throws IllegalArgumentException if there are fewer than 4
   */
  public Couette {
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
    return new ViscousFlow(lattice(), walls(), DENSITY, VISCOSITY, 0, SOUND_SPEED);
  }

  @Override
  public SphSchemeBuilder settings() {
    return flow().settings();
  }

  @Override
  public Particles particles() {
    Particles resting = flow().particles(disorder);
    Particles particles = new Particles();
    for (int n = 0; n < resting.count(); n++) {
      boolean upper = resting.phase(n) == 1 && resting.y(n) > lowerWall() + GAP;
      double u = upper ? WALL_VELOCITY : 0;
      particles.add(resting.phase(n), resting.x(n), resting.y(n), resting.z(n), u, 0, 0);
    }
    return particles;
  }

  /**
   * Velocity of the exact solution (Morris et al. 1997, eq. 20).
   *
   * @param height above the lower wall, 0 to L
   * @param time since the wall began to move
   */
  public static double velocity(double height, double time) {
    double sum = 0;
    for (int n = TERMS; n > 0; n--) { // small terms first
      double wave = n * Math.PI / GAP;
      double part = 2 * WALL_VELOCITY / (n * Math.PI) * (n % 2 == 0 ? 1 : -1);
      sum += part * Math.sin(wave * height) * Math.exp(-wave * wave * VISCOSITY * time);
    }
    return WALL_VELOCITY * height / GAP + sum;
  }
}
