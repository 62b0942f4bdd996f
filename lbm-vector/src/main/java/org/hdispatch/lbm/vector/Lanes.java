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

  static DoubleVector load(float[] from, int at) {
    return (DoubleVector)
        FloatVector.fromArray(FLOATS, from, at).convertShape(VectorOperators.F2D, DOUBLES, 0);
  }

  static void store(DoubleVector vector, float[] to, int at) {
    ((FloatVector) vector.convertShape(VectorOperators.D2F, FLOATS, 0)).intoArray(to, at);
  }
}
