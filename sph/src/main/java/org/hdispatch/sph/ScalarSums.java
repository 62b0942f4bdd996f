package org.hdispatch.sph;

import static org.hdispatch.sph.Neighbourhood.DEPTH;
import static org.hdispatch.sph.Neighbourhood.LANES;
import static org.hdispatch.sph.Neighbourhood.PRESSURE;
import static org.hdispatch.sph.Neighbourhood.UX;
import static org.hdispatch.sph.Neighbourhood.UY;
import static org.hdispatch.sph.Neighbourhood.UZ;
import static org.hdispatch.sph.Neighbourhood.VISCOSITY;
import static org.hdispatch.sph.Neighbourhood.VOLUME;
import static org.hdispatch.sph.Neighbourhood.X;
import static org.hdispatch.sph.Neighbourhood.Y;
import static org.hdispatch.sph.Neighbourhood.Z;

/**
 * Sums in plain Java, for any JVM and any kernel. The neighbours of a particle are picked out of
 * its quads; then distances, kernel values and sums are taken one after the other for all of them,
 * in loops short enough for the compiler to turn some of them into vector instructions.
 */
final class ScalarSums implements PairSums {
  private final PairModel model;
  private final SmoothingKernel kernel;
  private double[] squares = new double[0];
  private double[] weights = new double[0]; // W, or (dW/dr)/r
  private double[] drag = new double[0];
  private double[] push = new double[0]; // by pressure, where there are walls or several phases
  private double[] bend = new double[0]; // of the velocity in walls
  private int[] picked = new int[0];
  private final double beyond; // square of a distance at which the kernel is 0, rounding and all

  ScalarSums(PairModel model) {
    this.model = model;
    kernel = model.kernel();
    beyond = kernel.supportRadius() * kernel.supportRadius() * (1 + 1e-12);
  }

  private void makeRoom(int most) {
    if (squares.length < most) {
      squares = new double[most + most / 4];
      weights = new double[squares.length];
      drag = new double[squares.length];
      push = new double[squares.length];
      bend = new double[squares.length];
      picked = new int[squares.length];
    }
  }

  @Override
  public void search(Neighbourhood near, double reach, NeighbourList list) {
    int all = near.quads() * LANES;
    makeRoom(all);
    list.clear(near.ownCount());
    int[] first = list.first();
    double square = reach * reach;
    int length = 0;
    for (int i = 0; i < near.ownCount(); i++) {
      list.makeRoom(length + near.quads());
      char[] quads = list.quads();
      squaresOfAll(near, near.own() + i, all, squares);
      for (int n = 0; n < all; n += LANES) {
        double least =
            Math.min(
                Math.min(squares[n], squares[n + 1]), Math.min(squares[n + 2], squares[n + 3]));
        if (least < square) {
          quads[length++] = (char) (n / LANES);
        }
      }
      first[i + 1] = length;
    }
  }

  private static void squaresOfAll(Neighbourhood near, int particle, int all, double[] squares) {
    double[] values = near.values();
    int y = Y * near.stride();
    int z = Z * near.stride();
    double xi = values[particle];
    double yi = values[y + particle];
    double zi = values[z + particle];
    for (int n = 0; n < all; n++) {
      squares[n] = square(xi - values[n], yi - values[y + n], zi - values[z + n]);
    }
  }

  private static double square(double dx, double dy, double dz) {
    return Math.fma(dz, dz, Math.fma(dy, dy, Math.fma(dx, dx, LEAST_SQUARE)));
  }

  @Override
  public void density(Neighbourhood near, NeighbourList list, double[] density) {
    makeRoom(near.quads() * LANES);
    for (int i = 0; i < near.ownCount(); i++) {
      int count = pick(near, i, list);
      kernel.shapes(squares, weights, count);
      double s0 = 0;
      double s1 = 0;
      double s2 = 0;
      double s3 = 0;
      for (int n = 0; n < count; n += LANES) {
        s0 += weights[n];
        s1 += weights[n + 1];
        s2 += weights[n + 2];
        s3 += weights[n + 3];
      }
      density[i] = kernel.valueFactor() * ((s0 + s1) + (s2 + s3));
    }
  }

  /**
   * Picks the neighbours within the support, and gives the length of what is picked. The m-th of
   * those in lane l of their quads comes to 4 m + l; where a lane has fewer than others, particles
   * follow that add 0. So the partial sums add up what they would for whole quads, in their order.
   */
  private int pick(Neighbourhood near, int i, NeighbourList list) {
    double[] values = near.values();
    char[] quads = list.quads();
    double[] to = squares;
    int[] which = picked;
    double limit = beyond;
    int y = Y * near.stride();
    int z = Z * near.stride();
    int particle = near.own() + i;
    double xi = values[particle];
    double yi = values[y + particle];
    double zi = values[z + particle];
    int at0 = 0;
    int at1 = 1;
    int at2 = 2;
    int at3 = 3;
    int end = list.first()[i + 1];
    for (int entry = list.first()[i]; entry < end; entry++) {
      int n = quads[entry] * LANES;
      double square = square(xi - values[n], yi - values[y + n], zi - values[z + n]);
      to[at0] = square;
      which[at0] = n;
      at0 += square < limit ? LANES : 0;
      square = square(xi - values[n + 1], yi - values[y + n + 1], zi - values[z + n + 1]);
      to[at1] = square;
      which[at1] = n + 1;
      at1 += square < limit ? LANES : 0;
      square = square(xi - values[n + 2], yi - values[y + n + 2], zi - values[z + n + 2]);
      to[at2] = square;
      which[at2] = n + 2;
      at2 += square < limit ? LANES : 0;
      square = square(xi - values[n + 3], yi - values[y + n + 3], zi - values[z + n + 3]);
      to[at3] = square;
      which[at3] = n + 3;
      at3 += square < limit ? LANES : 0;
    }
    int length = Math.max(Math.max(at0, at1), Math.max(at2, at3)) / LANES * LANES;
    fill(at0, length, particle);
    fill(at1, length, particle);
    fill(at2, length, particle);
    fill(at3, length, particle);
    return length;
  }

  private void fill(int from, int length, int particle) {
    for (int k = from; k < length; k += LANES) {
      squares[k] = beyond;
      picked[k] = particle;
    }
  }

  @Override
  public void force(
      Neighbourhood near, NeighbourList list, double[] x, double[] y, double[] z, double[] share) {
    makeRoom(near.quads() * LANES);
    for (int i = 0; i < near.ownFluids(); i++) {
      int count = pick(near, i, list);
      kernel.slopes(squares, weights, count);
      if (model.uniform()) {
        uniformDrag(near, i, count);
        sum(near, i, count, x, y, z);
        share[i] = 1;
        continue;
      }
      if (model.mean() == ViscosityMean.ARITHMETIC) {
        arithmeticDrag(near, i, count);
      } else {
        harmonicDrag(near, i, count);
      }
      setPush(near, i, count);
      share[i] = share(near, i, count);
      x[i] = sum(near, i, count, X, UX, share[i]);
      y[i] = sum(near, i, count, Y, UY, share[i]);
      z[i] = sum(near, i, count, Z, UZ, share[i]);
    }
  }

  private void uniformDrag(Neighbourhood near, int i, int count) {
    double[] values = near.values();
    int volume = VOLUME * near.stride();
    double own = 2 * model.uniformViscosity() * values[volume + near.own() + i];
    for (int k = 0; k < count; k++) {
      drag[k] = own * values[volume + picked[k]] * weights[k];
    }
  }

  private void arithmeticDrag(Neighbourhood near, int i, int count) {
    double[] values = near.values();
    int volume = VOLUME * near.stride();
    int viscosity = VISCOSITY * near.stride();
    int depth = DEPTH * near.stride();
    int particle = near.own() + i;
    double own = values[volume + particle];
    double mu = values[viscosity + particle];
    double nearness = near.nearness()[i];
    double most = model.wallFactor();
    for (int k = 0; k < count; k++) {
      int n = picked[k];
      double free = Math.fma(values[depth + n], nearness, 1);
      double wall = free > most ? most : free;
      double other = values[viscosity + n];
      double pair = own * values[volume + n] * weights[k] * (mu + (other == 0 ? mu : other));
      drag[k] = pair * wall;
      bend[k] = pair * free * (free - 1);
    }
  }

  private void harmonicDrag(Neighbourhood near, int i, int count) {
    double[] values = near.values();
    int volume = VOLUME * near.stride();
    int viscosity = VISCOSITY * near.stride();
    int depth = DEPTH * near.stride();
    int particle = near.own() + i;
    double own = values[volume + particle];
    double fluidity = values[viscosity + particle];
    double nearness = near.nearness()[i];
    double most = model.wallFactor();
    for (int k = 0; k < count; k++) {
      int n = picked[k];
      double free = Math.fma(values[depth + n], nearness, 1);
      double wall = free > most ? most : free;
      double other = values[viscosity + n];
      double both = fluidity + (other == 0 ? fluidity : other);
      double pair = own * values[volume + n] * weights[k] * (4 / both);
      drag[k] = pair * wall;
      bend[k] = pair * free * (free - 1);
    }
  }

  private void setPush(Neighbourhood near, int i, int count) {
    double[] values = near.values();
    int pressure = PRESSURE * near.stride();
    double own = values[pressure + near.own() + i];
    for (int k = 0; k < count; k++) {
      push[k] = -(own + values[pressure + picked[k]]) * weights[k];
    }
  }

  private double share(Neighbourhood near, int i, int count) {
    double s0 = 0;
    double s1 = 0;
    double s2 = 0;
    double s3 = 0;
    for (int k = 0; k < count; k += LANES) {
      s0 += bend[k];
      s1 += bend[k + 1];
      s2 += bend[k + 2];
      s3 += bend[k + 3];
    }
    double sum = kernel.slopeFactor() * ((s0 + s1) + (s2 + s3));
    double[] values = near.values();
    int particle = near.own() + i;
    return model.share(
        sum,
        near.nearness()[i],
        values[VOLUME * near.stride() + particle],
        values[VISCOSITY * near.stride() + particle]);
  }

  /** Force in one direction by pressure, and by viscosity over a share. */
  private double sum(Neighbourhood near, int i, int count, int place, int speed, double share) {
    double pushed = differences(near, i, count, place, push);
    double dragged = differences(near, i, count, speed, drag);
    return kernel.slopeFactor() * (pushed + dragged / share);
  }

  /** Sum of a weight times how much less a quantity is at a neighbour than at the particle. */
  private double differences(Neighbourhood near, int i, int count, int plane, double[] weight) {
    double[] v = near.values();
    int at = plane * near.stride();
    double own = v[at + near.own() + i];
    double s0 = 0;
    double s1 = 0;
    double s2 = 0;
    double s3 = 0;
    for (int k = 0; k < count; k += LANES) {
      s0 = Math.fma(own - v[at + picked[k]], weight[k], s0);
      s1 = Math.fma(own - v[at + picked[k + 1]], weight[k + 1], s1);
      s2 = Math.fma(own - v[at + picked[k + 2]], weight[k + 2], s2);
      s3 = Math.fma(own - v[at + picked[k + 3]], weight[k + 3], s3);
    }
    return (s0 + s1) + (s2 + s3);
  }

  /**
   * Adds up the forces of all neighbours where viscosity is the same for all: four partial sums for
   * each direction.
   */
  private void sum(Neighbourhood near, int i, int count, double[] x, double[] y, double[] z) {
    double[] v = near.values();
    double[] slopes = weights;
    int[] which = picked;
    int s = near.stride();
    int own = near.own() + i;
    double xi = v[own];
    double yi = v[Y * s + own];
    double zi = v[Z * s + own];
    double ux = v[UX * s + own];
    double uy = v[UY * s + own];
    double uz = v[UZ * s + own];
    double pi = v[PRESSURE * s + own];
    double x0 = 0;
    double x1 = 0;
    double x2 = 0;
    double x3 = 0;
    double y0 = 0;
    double y1 = 0;
    double y2 = 0;
    double y3 = 0;
    double z0 = 0;
    double z1 = 0;
    double z2 = 0;
    double z3 = 0;
    for (int k = 0; k < count; k += LANES) {
      int n = which[k];
      double p = -(pi + v[PRESSURE * s + n]) * slopes[k];
      double m = drag[k];
      x0 = Math.fma(ux - v[UX * s + n], m, Math.fma(xi - v[X * s + n], p, x0));
      y0 = Math.fma(uy - v[UY * s + n], m, Math.fma(yi - v[Y * s + n], p, y0));
      z0 = Math.fma(uz - v[UZ * s + n], m, Math.fma(zi - v[Z * s + n], p, z0));
      n = which[k + 1];
      p = -(pi + v[PRESSURE * s + n]) * slopes[k + 1];
      m = drag[k + 1];
      x1 = Math.fma(ux - v[UX * s + n], m, Math.fma(xi - v[X * s + n], p, x1));
      y1 = Math.fma(uy - v[UY * s + n], m, Math.fma(yi - v[Y * s + n], p, y1));
      z1 = Math.fma(uz - v[UZ * s + n], m, Math.fma(zi - v[Z * s + n], p, z1));
      n = which[k + 2];
      p = -(pi + v[PRESSURE * s + n]) * slopes[k + 2];
      m = drag[k + 2];
      x2 = Math.fma(ux - v[UX * s + n], m, Math.fma(xi - v[X * s + n], p, x2));
      y2 = Math.fma(uy - v[UY * s + n], m, Math.fma(yi - v[Y * s + n], p, y2));
      z2 = Math.fma(uz - v[UZ * s + n], m, Math.fma(zi - v[Z * s + n], p, z2));
      n = which[k + 3];
      p = -(pi + v[PRESSURE * s + n]) * slopes[k + 3];
      m = drag[k + 3];
      x3 = Math.fma(ux - v[UX * s + n], m, Math.fma(xi - v[X * s + n], p, x3));
      y3 = Math.fma(uy - v[UY * s + n], m, Math.fma(yi - v[Y * s + n], p, y3));
      z3 = Math.fma(uz - v[UZ * s + n], m, Math.fma(zi - v[Z * s + n], p, z3));
    }
    double factor = kernel.slopeFactor();
    x[i] = factor * ((x0 + x1) + (x2 + x3));
    y[i] = factor * ((y0 + y1) + (y2 + y3));
    z[i] = factor * ((z0 + z1) + (z2 + z3));
  }
}
