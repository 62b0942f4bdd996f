package org.hdispatch.lbm.vector;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;

/** Shapes of the vectors, and the change of precision between them. */
final class Lanes {
  /** The longest that this processor has. */
  static final VectorSpecies<Double> DOUBLES = DoubleVector.SPECIES_PREFERRED;

  /** As many numbers in single precision. */
  static final VectorSpecies<Float> FLOATS =
      VectorSpecies.of(float.class, VectorShape.forBitSize(DOUBLES.length() * Float.SIZE));

  private Lanes() {}

  /** Copies n numbers from single to double precision. */
  static void widen(float[] from, int at, double[] to, int n) {
    int whole = DOUBLES.loopBound(n);
    for (int k = 0; k < whole; k += DOUBLES.length()) {
      FloatVector.fromArray(FLOATS, from, at + k)
          .convertShape(VectorOperators.F2D, DOUBLES, 0)
          .reinterpretAsDoubles()
          .intoArray(to, k);
    }
    for (int k = whole; k < n; k++) {
      to[k] = from[at + k];
    }
  }

  /** Copies n numbers from double to single precision. */
  static void narrow(double[] from, float[] to, int at, int n) {
    int whole = DOUBLES.loopBound(n);
    for (int k = 0; k < whole; k += DOUBLES.length()) {
      DoubleVector.fromArray(DOUBLES, from, k)
          .convertShape(VectorOperators.D2F, FLOATS, 0)
          .reinterpretAsFloats()
          .intoArray(to, at + k);
    }
    for (int k = whole; k < n; k++) {
      to[at + k] = (float) from[k];
    }
  }
}
