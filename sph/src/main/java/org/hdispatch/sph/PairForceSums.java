package org.hdispatch.sph;

import static org.hdispatch.sph.Neighbourhood.LANES;
import static org.hdispatch.sph.Neighbourhood.PHASE;
import static org.hdispatch.sph.Neighbourhood.X;
import static org.hdispatch.sph.Neighbourhood.Y;
import static org.hdispatch.sph.Neighbourhood.Z;

/**
 * Adds {@link PairForces} to the forces on the fluid particles of a cell, over the quads of their
 * lists, and sums up their virial. One for each worker.
 */
final class PairForceSums {
  private final PairForces forces;
  private final double inverseReach;

  // the polynomial of the profile
  private final double c0;
  private final double c1;
  private final double c2;
  private final double c3;
  private final double c4;
  private final double c5;
  private final double c6;
  private final double c7;
  private final double c8;
  private final double c9;
  private final double c10;
  private final double c11;
  private final double c12;

  private double[] squares = new double[0];
  private double[] strengths = new double[0]; // s, then s f/r

  PairForceSums(PairForces forces, double reach) {
    this.forces = forces;
    inverseReach = 1 / reach;
    PairProfile profile = forces.profile();
    c0 = profile.coefficient(0);
    c1 = profile.coefficient(1);
    c2 = profile.coefficient(2);
    c3 = profile.coefficient(3);
    c4 = profile.coefficient(4);
    c5 = profile.coefficient(5);
    c6 = profile.coefficient(6);
    c7 = profile.coefficient(7);
    c8 = profile.coefficient(8);
    c9 = profile.coefficient(9);
    c10 = profile.coefficient(10);
    c11 = profile.coefficient(11);
    c12 = profile.coefficient(12);
  }

  /**
   * Adds the forces.
   *
   * @param near positions and phases
   * @param list the neighbours of the cell's own particles
   * @param x force along x, by own fluid particle
   * @param y force along y
   * @param z force along z
   * @param virial where sum_j F_i&lt;-j . (r_i - r_j) goes
   */
  void add(
      Neighbourhood near, NeighbourList list, double[] x, double[] y, double[] z, double[] virial) {
    int most = near.quads() * LANES;
    if (squares.length < most) {
      squares = new double[most + most / 4];
      strengths = new double[squares.length];
    }
    for (int i = 0; i < near.ownFluids(); i++) {
      int count = gather(near, i, list);
      setForces(squares, strengths, count);
      sum(near, i, list, x, y, z, virial);
    }
  }

  private int gather(Neighbourhood near, int i, NeighbourList list) {
    double[] values = near.values();
    char[] quads = list.quads();
    double[] to = squares;
    double[] s = strengths;
    int y = Y * near.stride();
    int z = Z * near.stride();
    int phase = PHASE * near.stride();
    int particle = near.own() + i;
    double xi = values[particle];
    double yi = values[y + particle];
    double zi = values[z + particle];
    double[] row = forces.strengths((int) values[phase + particle]);
    int count = 0;
    for (int entry = list.first()[i]; entry < list.first()[i + 1]; entry++) {
      int from = quads[entry] * LANES;
      for (int n = from; n < from + LANES; n++) {
        double dx = xi - values[n];
        double dy = yi - values[y + n];
        double dz = zi - values[z + n];
        to[count] = Math.fma(dz, dz, Math.fma(dy, dy, Math.fma(dx, dx, PairSums.LEAST_SQUARE)));
        s[count++] = row[(int) values[phase + n]];
      }
    }
    return count;
  }

  /** Makes s f/r of s; a loop without a branch, which compilers turn into vector instructions. */
  private void setForces(double[] r2, double[] s, int count) {
    for (int n = 0; n < count; n++) {
      double r = Math.sqrt(r2[n]);
      double t = Math.min(r * inverseReach, 1);
      double u = Math.fma(2, t, -1);
      double high = Math.fma(Math.fma(Math.fma(Math.fma(c12, u, c11), u, c10), u, c9), u, c8);
      double middle = Math.fma(Math.fma(Math.fma(Math.fma(high, u, c7), u, c6), u, c5), u, c4);
      double low = Math.fma(Math.fma(Math.fma(Math.fma(middle, u, c3), u, c2), u, c1), u, c0);
      s[n] = s[n] * (1 - t) * low / r;
    }
  }

  private void sum(
      Neighbourhood near,
      int i,
      NeighbourList list,
      double[] x,
      double[] y,
      double[] z,
      double[] virial) {
    double[] values = near.values();
    char[] quads = list.quads();
    double[] r2 = squares;
    double[] f = strengths;
    int ys = Y * near.stride();
    int zs = Z * near.stride();
    int particle = X * near.stride() + near.own() + i;
    double xi = values[particle];
    double yi = values[ys + particle];
    double zi = values[zs + particle];
    double fx = 0;
    double fy = 0;
    double fz = 0;
    double work = 0;
    int k = 0;
    for (int entry = list.first()[i]; entry < list.first()[i + 1]; entry++) {
      int from = quads[entry] * LANES;
      for (int n = from; n < from + LANES; n++) {
        fx = Math.fma(xi - values[n], f[k], fx);
        fy = Math.fma(yi - values[ys + n], f[k], fy);
        fz = Math.fma(zi - values[zs + n], f[k], fz);
        work = Math.fma(r2[k], f[k], work);
        k++;
      }
    }
    x[i] += fx;
    y[i] += fy;
    z[i] += fz;
    virial[i] = work;
  }
}
