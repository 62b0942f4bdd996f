package org.hdispatch.sph;

import java.util.Arrays;

/** Particles in one of the two buffers of a cell: an array a quantity. */
final class ParticleArrays {
  private static final int DOUBLES = 9;

  double[] x = new double[0];
  double[] y = new double[0];
  double[] z = new double[0];

  /** Velocity half a step earlier. */
  double[] vx = new double[0];

  double[] vy = new double[0];
  double[] vz = new double[0];

  /** Velocity at the time of the position, as far as the last acceleration tells. */
  double[] ux = new double[0];

  double[] uy = new double[0];
  double[] uz = new double[0];

  byte[] phase = new byte[0];
  int[] id = new int[0];

  /** Makes room for so many particles; those here stay. */
  void makeRoom(int count) {
    if (count <= id.length) {
      return;
    }
    int room = roomFor(count);
    x = Arrays.copyOf(x, room);
    y = Arrays.copyOf(y, room);
    z = Arrays.copyOf(z, room);
    vx = Arrays.copyOf(vx, room);
    vy = Arrays.copyOf(vy, room);
    vz = Arrays.copyOf(vz, room);
    ux = Arrays.copyOf(ux, room);
    uy = Arrays.copyOf(uy, room);
    uz = Arrays.copyOf(uz, room);
    phase = Arrays.copyOf(phase, room);
    id = Arrays.copyOf(id, room);
  }

  /** Some more than asked for, so that a cell soon grows no more. */
  static int roomFor(int count) {
    return count + count / 6 + 2;
  }

  /** Copies a particle, which is then seen elsewhere. */
  void copy(int to, ParticleArrays other, int from, double dx, double dy, double dz) {
    x[to] = other.x[from] + dx;
    y[to] = other.y[from] + dy;
    z[to] = other.z[from] + dz;
    vx[to] = other.vx[from];
    vy[to] = other.vy[from];
    vz[to] = other.vz[from];
    ux[to] = other.ux[from];
    uy[to] = other.uy[from];
    uz[to] = other.uz[from];
    phase[to] = other.phase[from];
    id[to] = other.id[from];
  }

  /** Bytes of the arrays. */
  long bytes() {
    long room = id.length;
    int arrays = DOUBLES + 2;
    return room * (DOUBLES * Double.BYTES + Byte.BYTES + Integer.BYTES)
        + (long) arrays * ParticleCell.HEADER;
  }
}
