package org.hdispatch.sph.vector;

import static org.hdispatch.sph.Neighbourhood.LANES;
import static org.hdispatch.sph.Neighbourhood.Y;
import static org.hdispatch.sph.Neighbourhood.Z;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;
import org.hdispatch.sph.NeighbourList;
import org.hdispatch.sph.Neighbourhood;
import org.hdispatch.sph.PairModel;
import org.hdispatch.sph.PairSums;
import org.hdispatch.sph.ViscosityMean;

/**
 * What the sums of all smoothing kernels have in common: the search, and the way from the cell to
 * the loop over the quads of one particle, which is written out for a kernel and a model.
 *
 * <p>Each loop stands in a method of its own, or C2 boxes vectors. It takes two quads at a time in
 * hand: of one the distances, of the one before all the rest, so that the square roots of one are
 * under way while the other is worked on.
 */
abstract class VectorSums implements PairSums {
  /** A quad, whatever the longest vectors of this processor. */
  static final VectorSpecies<Double> QUAD = DoubleVector.SPECIES_256;

  /** A distance, in h, at and beyond which all kernels are 0. */
  static final double FAR = 3;

  /** Partial sums of one particle: density, or force along x, y and z. */
  final double[] partial = new double[3 * LANES];

  private final PairModel model;

  VectorSums(PairModel model) {
    this.model = model;
  }

  /** Whether the registers of this processor hold four doubles. */
  static boolean quadsFitRegisters() {
    return DoubleVector.SPECIES_PREFERRED.length() >= LANES;
  }

  @Override
  public final void search(Neighbourhood near, double reach, NeighbourList list) {
    list.clear(near.ownCount(), near.quads());
    int[] first = list.first();
    for (int i = 0; i < near.ownCount(); i++) {
      first[i + 1] =
          find(
              near.values(),
              near.stride(),
              near.own() + i,
              near.quads(),
              reach * reach,
              list.quads(),
              first[i]);
    }
  }

  private static int find(
      double[] v, int stride, int own, int all, double square, char[] quads, int length) {
    int ys = Y * stride;
    int zs = Z * stride;
    DoubleVector x = DoubleVector.broadcast(QUAD, v[own]);
    DoubleVector y = DoubleVector.broadcast(QUAD, v[ys + own]);
    DoubleVector z = DoubleVector.broadcast(QUAD, v[zs + own]);
    DoubleVector limit = DoubleVector.broadcast(QUAD, square);
    DoubleVector least = DoubleVector.broadcast(QUAD, LEAST_SQUARE);
    for (int quad = 0; quad < all; quad++) {
      int n = quad * LANES;
      DoubleVector dx = DoubleVector.fromArray(QUAD, v, n).sub(x);
      DoubleVector dy = DoubleVector.fromArray(QUAD, v, ys + n).sub(y);
      DoubleVector dz = DoubleVector.fromArray(QUAD, v, zs + n).sub(z);
      DoubleVector squares = dz.fma(dz, dy.fma(dy, dx.fma(dx, least)));
      quads[length] = (char) quad;
      length += squares.compare(VectorOperators.LT, limit).anyTrue() ? 1 : 0;
    }
    return length;
  }

  @Override
  public final void density(Neighbourhood near, NeighbourList list, double[] density) {
    double[] values = near.values();
    int stride = near.stride();
    int own = near.own();
    int[] first = list.first();
    char[] quads = list.quads();
    double factor = model.kernel().valueFactor();
    for (int i = 0; i < near.ownCount(); i++) {
      density(values, stride, own + i, quads, first[i], first[i + 1]);
      density[i] = factor * sum(0);
    }
  }

  @Override
  public final void force(
      Neighbourhood near, NeighbourList list, double[] x, double[] y, double[] z) {
    double[] values = near.values();
    double[] nearness = near.nearness();
    int stride = near.stride();
    int own = near.own();
    int[] first = list.first();
    char[] quads = list.quads();
    double factor = model.kernel().slopeFactor();
    double twice = 2 * model.uniformViscosity();
    double most = model.wallFactor();
    boolean uniform = model.uniform();
    boolean arithmetic = model.mean() == ViscosityMean.ARITHMETIC;
    for (int i = 0; i < near.ownFluids(); i++) {
      if (uniform) {
        uniform(values, stride, own + i, quads, first[i], first[i + 1], twice);
      } else if (arithmetic) {
        arithmetic(values, stride, own + i, quads, first[i], first[i + 1], nearness[i], most);
      } else {
        harmonic(values, stride, own + i, quads, first[i], first[i + 1], nearness[i], most);
      }
      x[i] = factor * sum(0);
      y[i] = factor * sum(LANES);
      z[i] = factor * sum(2 * LANES);
    }
  }

  private double sum(int at) {
    return (partial[at] + partial[at + 1]) + (partial[at + 2] + partial[at + 3]);
  }

  /** Partial sums of the shape of the kernel over the quads from..to of a list. */
  abstract void density(double[] values, int stride, int own, char[] quads, int from, int to);

  /** Partial sums of the force where viscosity is the same for all, and there are no walls. */
  abstract void uniform(
      double[] values, int stride, int own, char[] quads, int from, int to, double twiceViscosity);

  /** Partial sums of the force with arithmetic means of the viscosity. */
  abstract void arithmetic(
      double[] values,
      int stride,
      int own,
      char[] quads,
      int from,
      int to,
      double nearness,
      double wallFactor);

  /** Partial sums of the force with harmonic means of the viscosity. */
  abstract void harmonic(
      double[] values,
      int stride,
      int own,
      char[] quads,
      int from,
      int to,
      double nearness,
      double wallFactor);
}
