package org.hdispatch.sph.vector;

import static org.hdispatch.sph.Neighbourhood.LANES;
import static org.hdispatch.sph.Neighbourhood.VISCOSITY;
import static org.hdispatch.sph.Neighbourhood.VOLUME;
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
  /*
   * Two more rules keep C2 of JDK 17 from boxing, both because of what its profiles hold.
   *
   * All binary and unary operations pass through VectorOperators.opKind, whose profile holds the
   * class of operator. While only binary ones have been seen, C2 takes that class for granted; the
   * first unary ones trap, up to four times, and every operation inlined from then on counts these
   * traps. Past a hundred (PerMethodTrapLimit), hence 25 operations, C2 no longer trusts any type
   * in the rest of a method, and what it does not know to be a Double256Vector is boxed. So
   * find(), which runs long before all else, must do with ternary operations: binary ones are
   * first met together with unary ones.
   *
   * Sums leave a loop by lane(), which Double256Vector overrides, so that C2 knows the type in it.
   * It must guess it in intoArray(), a method of DoubleVector.
   */

  /** A quad, whatever the longest vectors of this processor. */
  static final VectorSpecies<Double> QUAD = DoubleVector.SPECIES_256;

  /** A distance, in h, at and beyond which all kernels are 0. */
  static final double FAR = 3;

  /**
   * Sums of one particle: force along x, y and z; where there are walls or several phases, that by
   * pressure, then that by viscosity, then the bend of the velocity in walls.
   */
  final double[] sums = new double[7];

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
    list.clear(near.ownCount());
    int[] first = list.first();
    for (int i = 0; i < near.ownCount(); i++) {
      list.makeRoom(first[i] + near.quads());
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
    DoubleVector minusX = DoubleVector.broadcast(QUAD, -v[own]);
    DoubleVector minusY = DoubleVector.broadcast(QUAD, -v[ys + own]);
    DoubleVector minusZ = DoubleVector.broadcast(QUAD, -v[zs + own]);
    DoubleVector one = DoubleVector.broadcast(QUAD, 1);
    DoubleVector limit = DoubleVector.broadcast(QUAD, square);
    DoubleVector least = DoubleVector.broadcast(QUAD, LEAST_SQUARE);
    for (int quad = 0; quad < all; quad++) {
      int n = quad * LANES;
      // x_j * 1 - x_i: the bits of the difference, by a ternary operation
      DoubleVector dx = DoubleVector.fromArray(QUAD, v, n).fma(one, minusX);
      DoubleVector dy = DoubleVector.fromArray(QUAD, v, ys + n).fma(one, minusY);
      DoubleVector dz = DoubleVector.fromArray(QUAD, v, zs + n).fma(one, minusZ);
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
      density[i] = factor * density(values, stride, own + i, quads, first[i], first[i + 1]);
    }
  }

  @Override
  public final void force(
      Neighbourhood near, NeighbourList list, double[] x, double[] y, double[] z, double[] share) {
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
        x[i] = factor * sums[0];
        y[i] = factor * sums[1];
        z[i] = factor * sums[2];
        share[i] = 1;
        continue;
      }
      if (arithmetic) {
        arithmetic(values, stride, own + i, quads, first[i], first[i + 1], nearness[i], most);
      } else {
        harmonic(values, stride, own + i, quads, first[i], first[i + 1], nearness[i], most);
      }
      share[i] =
          model.share(
              factor * sums[6],
              nearness[i],
              values[VOLUME * stride + own + i],
              values[VISCOSITY * stride + own + i]);
      x[i] = factor * (sums[0] + sums[3] / share[i]);
      y[i] = factor * (sums[1] + sums[4] / share[i]);
      z[i] = factor * (sums[2] + sums[5] / share[i]);
    }
  }

  /** Sum of the shape of the kernel over the quads from..to of a list. */
  abstract double density(double[] values, int stride, int own, char[] quads, int from, int to);

  /** Sums of the force where viscosity is the same for all, and there are no walls. */
  abstract void uniform(
      double[] values, int stride, int own, char[] quads, int from, int to, double twiceViscosity);

  /** Sums of the force with arithmetic means of the viscosity. */
  abstract void arithmetic(
      double[] values,
      int stride,
      int own,
      char[] quads,
      int from,
      int to,
      double nearness,
      double wallFactor);

  /** Sums of the force with harmonic means of the viscosity. */
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
