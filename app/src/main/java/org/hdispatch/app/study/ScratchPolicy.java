package org.hdispatch.app.study;

/** Who keeps the scratch that a cell needs, and for how long. */
public enum ScratchPolicy {
  /** An enduring worker, for good: made once, never reclaimed. */
  ENDURING,
  /** An enduring worker, for a step. */
  PER_STEP,
  /** Nobody: made anew for every cell. */
  PER_CELL,
  /** A {@link ThreadLocal} of the threads of a fixed pool of the JDK that runs a task a cell. */
  THREAD_LOCAL_POOL,
  /** A {@link ThreadLocal} of virtual threads, one a cell (Java 21 and newer). */
  THREAD_LOCAL_VIRTUAL,
  /** A queue from which enduring workers borrow for each cell. */
  OBJECT_POOL
}
