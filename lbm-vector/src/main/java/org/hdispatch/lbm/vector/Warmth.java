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

  /** Calls that C2 wants to have seen, and some more; then only some give the loop a vector. */
  private static final int COUNTED_CALLS = 4_000;

  private static final int FEWER = 16;

  private int calls;
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
    calls++;
    if (n < species.length() || calls > COUNTED_CALLS && calls % FEWER != 0) {
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
