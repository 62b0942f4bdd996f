package org.hdispatch.lbm.vector;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorSpecies;
import org.hdispatch.lbm.CollisionCoefficients;
import org.hdispatch.lbm.CollisionKernel;
import org.hdispatch.lbm.KernelForm;

/**
 * What the kernels have in common: whole vectors of nodes go to loops written out for a lattice and
 * an equilibrium, the nodes left over at the ends of rows to a kernel that does them one by one.
 * (Single nodes within the same method make C2 box the vectors: forty times slower.)
 */
abstract class VectorKernel implements CollisionKernel {
  /** The longest vectors of this processor. */
  static final VectorSpecies<Double> DOUBLES = DoubleVector.SPECIES_PREFERRED;

  /** The longest vectors of this processor. */
  static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;

  private final CollisionKernel rest;
  private final int[] restIn;
  private final int[] restOut;

  VectorKernel(CollisionCoefficients coefficients) {
    rest = KernelForm.SCALAR.kernels().kernel(coefficients);
    restIn = new int[coefficients.set().size()];
    restOut = new int[coefficients.set().size()];
  }

  @Override
  public final void collide(
      double[][] in, int[] inAt, double[][] out, int[] outAt, int n, int rows, int pitch) {
    int whole = DOUBLES.loopBound(n);
    if (whole > 0) {
      if (in == out && inAt == outAt) {
        inPlace(in, inAt, whole, rows, pitch);
      } else {
        apart(in, inAt, out, outAt, whole, rows, pitch);
      }
    }
    if (whole < n) {
      shift(inAt, outAt, whole);
      rest.collide(in, restIn, out, restOut, n - whole, rows, pitch);
    }
  }

  @Override
  public final void collide(
      float[][] in, int[] inAt, float[][] out, int[] outAt, int n, int rows, int pitch) {
    int whole = FLOATS.loopBound(n);
    if (whole > 0) {
      if (in == out && inAt == outAt) {
        inPlace(in, inAt, whole, rows, pitch);
      } else {
        apart(in, inAt, out, outAt, whole, rows, pitch);
      }
    }
    if (whole < n) {
      shift(inAt, outAt, whole);
      rest.collide(in, restIn, out, restOut, n - whole, rows, pitch);
    }
  }

  private void shift(int[] inAt, int[] outAt, int by) {
    for (int i = 0; i < restIn.length; i++) {
      restIn[i] = inAt[i] + by;
      restOut[i] = outAt[i] + by;
    }
  }

  /** Collides whole vectors where they stand; a loop of its own, as it needs half the addresses. */
  abstract void inPlace(double[][] in, int[] inAt, int n, int rows, int pitch);

  /** Collides whole vectors from one place to another. */
  abstract void apart(
      double[][] in, int[] inAt, double[][] out, int[] outAt, int n, int rows, int pitch);

  /** Collides whole vectors where they stand. */
  abstract void inPlace(float[][] in, int[] inAt, int n, int rows, int pitch);

  /** Collides whole vectors from one place to another. */
  abstract void apart(
      float[][] in, int[] inAt, float[][] out, int[] outAt, int n, int rows, int pitch);
}
