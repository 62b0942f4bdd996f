package org.hdispatch.lbm.vector;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorSpecies;
import org.hdispatch.lbm.CollisionCoefficients;
import org.hdispatch.lbm.CollisionKernel;
import org.hdispatch.lbm.KernelForm;

/**
 * What the kernels have in common: whole vectors of nodes go to loops written out for a lattice and
 * an equilibrium, the nodes left over at the ends of rows to a kernel that does them one by one,
 * and so do nearly all until those loops are compiled ({@link Warmth}). (Single nodes within the
 * same method make C2 box the vectors: forty times slower.)
 */
abstract class VectorKernel implements CollisionKernel {
  /** The longest vectors of this processor. */
  static final VectorSpecies<Double> DOUBLES = DoubleVector.SPECIES_PREFERRED;

  /** The longest vectors of this processor. */
  static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;

  /** Nodes that are moved before they are collided: few enough to stay in the L1 cache. */
  private static final int MOVED = 256;

  private final CollisionKernel rest;
  private final int[] restIn;
  private final int[] restOut;
  private final int[] moved;
  private final Warmth doubles = new Warmth();
  private final Warmth floats = new Warmth();

  VectorKernel(CollisionCoefficients coefficients) {
    rest = KernelForm.SCALAR.kernels().kernel(coefficients);
    restIn = new int[coefficients.set().size()];
    restOut = new int[coefficients.set().size()];
    moved = new int[coefficients.set().size()];
  }

  @Override
  public final void collide(
      double[][] in, int[] inAt, double[][] out, int[] outAt, int n, int rows, int pitch) {
    int whole = doubles.vectors(DOUBLES, n);
    if (whole > 0) {
      if (in == out && inAt == outAt) {
        inPlace(in, inAt, whole, rows, pitch);
      } else {
        apart(in, inAt, out, outAt, whole, rows, pitch);
      }
      doubles.done(rows);
    }
    if (whole < n) {
      shift(inAt, outAt, whole);
      rest.collide(in, restIn, out, restOut, n - whole, rows, pitch);
    }
  }

  @Override
  public final void collide(
      float[][] in, int[] inAt, float[][] out, int[] outAt, int n, int rows, int pitch) {
    int whole = floats.vectors(FLOATS, n);
    if (whole > 0) {
      if (in == out && inAt == outAt) {
        inPlace(in, inAt, whole, rows, pitch);
      } else {
        apart(in, inAt, out, outAt, whole, rows, pitch);
      }
      floats.done(rows);
    }
    if (whole < n) {
      shift(inAt, outAt, whole);
      rest.collide(in, restIn, out, restOut, n - whole, rows, pitch);
    }
  }

  /** See {@link Warmth#heat}. */
  final VectorKernel heat() {
    doubles.heat();
    floats.heat();
    return this;
  }

  private void shift(int[] inAt, int[] outAt, int by) {
    for (int i = 0; i < restIn.length; i++) {
      restIn[i] = inAt[i] + by;
      restOut[i] = outAt[i] + by;
    }
  }

  /**
   * Moves whole vectors and collides them where they come to stand. (A loop from one place to the
   * other needs twice the addresses; C2 then boxes the constants in each call.)
   */
  private void apart(
      double[][] in, int[] inAt, double[][] out, int[] outAt, int n, int rows, int pitch) {
    int group = Math.max(1, MOVED / n);
    for (int row = 0; row < rows; row += group) {
      int some = Math.min(group, rows - row);
      for (int first = 0; first < n; first += MOVED) {
        int nodes = Math.min(MOVED, n - first);
        for (int i = 0; i < moved.length; i++) {
          for (int r = row; r < row + some; r++) {
            int at = r * pitch + first;
            System.arraycopy(in[i], inAt[i] + at, out[i], outAt[i] + at, nodes);
          }
          moved[i] = outAt[i] + row * pitch + first;
        }
        inPlace(out, moved, nodes, some, pitch);
      }
    }
  }

  /**
   * Moves whole vectors and collides them where they come to stand. (A loop from one place to the
   * other needs twice the addresses; C2 then boxes the constants in each call.)
   */
  private void apart(
      float[][] in, int[] inAt, float[][] out, int[] outAt, int n, int rows, int pitch) {
    int group = Math.max(1, MOVED / n);
    for (int row = 0; row < rows; row += group) {
      int some = Math.min(group, rows - row);
      for (int first = 0; first < n; first += MOVED) {
        int nodes = Math.min(MOVED, n - first);
        for (int i = 0; i < moved.length; i++) {
          for (int r = row; r < row + some; r++) {
            int at = r * pitch + first;
            System.arraycopy(in[i], inAt[i] + at, out[i], outAt[i] + at, nodes);
          }
          moved[i] = outAt[i] + row * pitch + first;
        }
        inPlace(out, moved, nodes, some, pitch);
      }
    }
  }

  /** Collides whole vectors where they stand. */
  abstract void inPlace(double[][] in, int[] inAt, int n, int rows, int pitch);

  /** Collides whole vectors where they stand. */
  abstract void inPlace(float[][] in, int[] inAt, int n, int rows, int pitch);
}
