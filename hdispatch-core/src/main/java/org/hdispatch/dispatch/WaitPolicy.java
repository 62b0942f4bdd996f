package org.hdispatch.dispatch;

/** What a thread does while it has nothing to pull. */
public enum WaitPolicy {
  /** Spins: the fastest answer, a core burnt while idle. */
  SPIN(Long.MAX_VALUE),
  /** Spins for some tens of microseconds, then parks. */
  SPIN_THEN_PARK(3_000),
  /** Parks at once: for machines with more workers than free processors. */
  PARK(0);

  private final long spins;

  WaitPolicy(long spins) {
    this.spins = spins;
  }

  /** Number of looks before parking. */
  long spins() {
    return spins;
  }

  /** The default: spin briefly, but never with more workers than processors. */
  static WaitPolicy fitting(int workers) {
    return workers <= Runtime.getRuntime().availableProcessors() ? SPIN_THEN_PARK : PARK;
  }
}
