package org.hdispatch.bench.peer;

import java.util.concurrent.RecursiveAction;

/**
 * A tree of {@code RecursiveAction}s per step, split down to single cells (grain 1), so that any
 * cell can be stolen by itself. Each node forks its right half and goes on with its left one, then
 * takes back what nobody has stolen: the form of {@code RecursiveAction}'s own javadoc.
 *
 * <p>In the common pool and on the caller, for the reason of {@link StreamSweeper}. With 1 worker
 * the same tree without forks.
 */
public final class ForkJoinSweeper implements Sweeper {
  private final boolean forks;
  private final int cells;
  private final CellTask task;

  /**
   * Splits cells 0 to {@code cells - 1}.
   *
   * @throws IllegalArgumentException if {@code workers} is neither 1 nor the common pool's threads
   *     and the caller
   */
  public ForkJoinSweeper(int workers, int cells, CellTask task) {
    CommonPool.require(workers);
    forks = workers > 1;
    this.cells = cells;
    this.task = task;
  }

  @Override
  public void run(int steps) {
    for (int step = 0; step < steps; step++) {
      new Range(this, 0, cells, null).invoke();
    }
  }

  /** Cells {@code begin} to {@code end - 1}. */
  private static final class Range extends RecursiveAction {
    private static final long serialVersionUID = 1;

    private final transient ForkJoinSweeper sweeper;
    private final int begin;
    private final int end;
    private final transient Range next;

    Range(ForkJoinSweeper sweeper, int begin, int end, Range next) {
      this.sweeper = sweeper;
      this.begin = begin;
      this.end = end;
      this.next = next;
    }

    @Override
    protected void compute() {
      int middle = end;
      Range right = null;
      while (middle - begin > 1) {
        int last = middle;
        middle = begin + last >>> 1;
        right = new Range(sweeper, middle, last, right);
        if (sweeper.forks) {
          right.fork();
        }
      }
      sweeper.task.process(begin);
      for (; right != null; right = right.next) {
        if (!sweeper.forks || right.tryUnfork()) {
          right.compute();
        } else {
          right.join();
        }
      }
    }
  }

  @Override
  public void close() {
    // the common pool is the JVM's
  }
}
