package org.hdispatch.dispatch;

/**
 * The clock of a time loop: the number of the step, and which of two buffers holds the previous and
 * which the current values ("rolling memory": the index flips, nothing is copied).
 *
 * <p>The values given at the start belong into buffer {@code previous()} of step 0, which is 0.
 * Between two steps {@code previous()} is the buffer that the last step has written.
 */
public final class Tick {
  private long step;

  Tick() {}

  /** Number of the step in progress, from 0; between steps the number of steps completed. */
  public long step() {
    return step;
  }

  /** Buffer to read: 0 or 1. */
  public int previous() {
    return (int) (step & 1);
  }

  /** Buffer to write: 1 or 0. */
  public int current() {
    return (int) (step & 1) ^ 1;
  }

  void advance() {
    step++;
  }
}
