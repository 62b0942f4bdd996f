package org.hdispatch.lbm.vector;

import jdk.incubator.vector.VectorSpecies;

/**
 * How many nodes of a call go to the loop with vectors, which is of use only when C2 has compiled
 * it: until then every vector is an object, and a node takes hundreds of times longer.
 *
 * <p>So at first a call gives a single vector of each row to the loop and the rest to the kernel
 * that takes nodes one by one, which gives the same bits. That is enough for the JVM to count the
 * calls, and to compile. When a vector has been fast once, the loop gets all that it can take.
 */
final class Warmth {
  /** A single vector takes longer in objects, and less in registers; ns. */
  private static final long COLD_NANOS = 1_000;

  private boolean warm;
  private long begin;

  /**
   * Nodes of a call that go to the loop.
   *
   * @param n nodes of a row
   */
  int vectors(VectorSpecies<?> species, int n) {
    if (warm) {
      return species.loopBound(n);
    }
    if (n < species.length()) {
      return 0;
    }
    begin = System.nanoTime();
    return species.length();
  }

  /** From now on the loop gets all that it can take, compiled or not. */
  void heat() {
    warm = true;
  }

  /**
   * The loop has had what it was given.
   *
   * @param rows how many vectors that were, if it was cold
   */
  void done(int rows) {
    if (!warm) {
      warm = System.nanoTime() - begin < (1L + rows) * COLD_NANOS; // 1: the call itself
    }
  }
}
