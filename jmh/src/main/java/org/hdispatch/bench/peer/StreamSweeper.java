package org.hdispatch.bench.peer;

import java.util.stream.IntStream;

/**
 * A parallel stream per step, as most programs use it: the common fork-join pool and the caller.
 *
 * <p>Not in a pool of its own: there, with two threads and tiny steps, JDK 17 was seen to lose a
 * wake-up and hang for good.
 */
public final class StreamSweeper implements Sweeper {
  private final int workers;
  private final int cells;
  private final CellTask task;

  /**
   * Streams over cells 0 to {@code cells - 1}.
   *
   * @throws IllegalArgumentException if {@code workers} is neither 1 nor the common pool's threads
   *     and the caller
   */
  public StreamSweeper(int workers, int cells, CellTask task) {
    CommonPool.require(workers);
    this.workers = workers;
    this.cells = cells;
    this.task = task;
  }

  @Override
  public void run(int steps) {
    for (int step = 0; step < steps; step++) {
      IntStream range = IntStream.range(0, cells);
      (workers == 1 ? range : range.parallel()).forEach(task::process);
    }
  }

  @Override
  public void close() {
    // the common pool is the JVM's
  }
}
