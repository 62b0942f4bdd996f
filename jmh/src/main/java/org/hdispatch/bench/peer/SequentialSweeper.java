package org.hdispatch.bench.peer;

/** A loop on the caller's thread: what the tasks themselves cost. */
public final class SequentialSweeper implements Sweeper {
  private final int cells;
  private final CellTask task;

  /** A loop over cells 0 to {@code cells - 1}. */
  public SequentialSweeper(int cells, CellTask task) {
    this.cells = cells;
    this.task = task;
  }

  @Override
  public void run(int steps) {
    for (int step = 0; step < steps; step++) {
      for (int cell = 0; cell < cells; cell++) {
        task.process(cell);
      }
    }
  }

  @Override
  public void close() {
    // has no thread
  }
}
