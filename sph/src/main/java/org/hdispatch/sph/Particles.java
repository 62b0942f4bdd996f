package org.hdispatch.sph;

import java.util.Arrays;

/** Particles to begin with: a list of phases, places and velocities that grows. */
public final class Particles {
  private static final int FIRST_LENGTH = 1024;
  private static final int COORDINATES = 6;

  private double[] values = new double[COORDINATES * FIRST_LENGTH];
  private byte[] phases = new byte[FIRST_LENGTH];
  private int count;

  /** No particles. */
  public Particles() {}

  /**
   * Adds a particle; its identity is the number of those before it.
   *
   * @param phase number of its phase, in the order in which phases are given to the scheme
   * @param u velocity along x; of a solid that of the wall, which itself stays where it is
   * @param v velocity along y
   * @param w velocity along z
   * @return this
   */
  public Particles add(int phase, double x, double y, double z, double u, double v, double w) {
    if (count == phases.length) {
      values = Arrays.copyOf(values, 2 * values.length);
      phases = Arrays.copyOf(phases, 2 * phases.length);
    }
    int at = COORDINATES * count;
    values[at] = x;
    values[at + 1] = y;
    values[at + 2] = z;
    values[at + 3] = u;
    values[at + 4] = v;
    values[at + 5] = w;
    phases[count++] = (byte) phase;
    return this;
  }

  /** Adds a particle at rest. */
  public Particles add(int phase, double x, double y, double z) {
    return add(phase, x, y, z, 0, 0, 0);
  }

  /** How many there are. */
  public int count() {
    return count;
  }

  /** Phase of a particle. */
  public int phase(int particle) {
    return phases[particle];
  }

  /** Place along x. */
  public double x(int particle) {
    return values[COORDINATES * particle];
  }

  /** Place along y. */
  public double y(int particle) {
    return values[COORDINATES * particle + 1];
  }

  /** Place along z. */
  public double z(int particle) {
    return values[COORDINATES * particle + 2];
  }

  /** Velocity along x. */
  public double u(int particle) {
    return values[COORDINATES * particle + 3];
  }

  /** Velocity along y. */
  public double v(int particle) {
    return values[COORDINATES * particle + 4];
  }

  /** Velocity along z. */
  public double w(int particle) {
    return values[COORDINATES * particle + 5];
  }
}
