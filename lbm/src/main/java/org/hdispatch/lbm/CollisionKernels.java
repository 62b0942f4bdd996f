package org.hdispatch.lbm;

/**
 * Makes kernels; found by {@link java.util.ServiceLoader}, so that a form that needs a module which
 * not every JVM has can live in an artifact of its own.
 */
public interface CollisionKernels {
  /** Whether this JVM can run these kernels. */
  boolean available();

  /**
   * A kernel for one worker.
   *
   * @param coefficients shared with the other workers; the force in them may change between calls
   * @throws IllegalStateException if they are not {@link #available}
   */
  CollisionKernel kernel(CollisionCoefficients coefficients);
}
