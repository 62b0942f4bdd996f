package org.hdispatch.dispatch;

/**
 * How long a worker keeps its scratch. It never changes a result: the two short lives are the
 * control of a garbage-collection study, and a test that no kernel relies on old scratch.
 */
public enum ScratchLifetime {
  /** As long as the loop: made once by each worker, never reclaimed. */
  ENDURING,
  /** Made anew by each worker in each step. */
  PER_STEP,
  /** Made anew for each cell of each pass. */
  PER_CELL
}
