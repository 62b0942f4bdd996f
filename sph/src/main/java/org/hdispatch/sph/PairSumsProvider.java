package org.hdispatch.sph;

/** Makes the inner loops in a form that not every JVM can run; found by {@code ServiceLoader}. */
public interface PairSumsProvider {
  /** Whether this JVM can run them. */
  boolean available();

  /** Whether they are written for this kernel. */
  boolean serves(SmoothingKernel kernel);

  /** The loops of one worker. */
  PairSums sums(PairModel model);
}
