package org.hdispatch.dispatch;

import org.hdispatch.cell.CellChanges;

/**
 * The step in progress, as one worker sees it: its number, and which of two buffers holds the
 * previous and which the current values ("rolling memory": the index flips, nothing is copied).
 *
 * <p>The values given at the start belong into buffer {@code previous()} of step 0, which is 0.
 * Between two steps {@code previous()} is the buffer that the last step has written.
 */
public final class Tick {
  private final Clock clock;
  private final CellChanges changes = new CellChanges();

  /** Number of the step in progress, the same for all workers of a loop. */
  static final class Clock {
    long step; // written by the caller between passes
  }

  Tick(Clock clock) {
    this.clock = clock;
  }

  /** Number of the step in progress, from 0; between steps the number of steps completed. */
  public long step() {
    return clock.step;
  }

  /** Buffer to read: 0 or 1. */
  public int previous() {
    return (int) (clock.step & 1);
  }

  /** Buffer to write: 1 or 0. */
  public int current() {
    return (int) (clock.step & 1) ^ 1;
  }

  /**
   * The cells that this worker wants added and removed. The loop applies what all workers ask for
   * when the step is complete, after {@link Scheme#afterStep}; a step that fails or is cancelled
   * changes nothing. So the cells are the same for any number of workers. A new cell takes part
   * from the next step on: whoever makes it fills both buffers.
   */
  public CellChanges changes() {
    return changes;
  }
}
