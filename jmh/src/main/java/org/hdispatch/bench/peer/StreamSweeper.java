package org.hdispatch.bench.peer;

import java.util.concurrent.ForkJoinPool;
import java.util.stream.IntStream;

/**
 * A parallel stream per step, in a fork-join pool of its own. The steps run inside that pool, so
 * that one of its threads is the stream's caller and none is idle.
 */
public final class StreamSweeper implements Sweeper {
  private final ForkJoinPool threads;
  private final int cells;
  private final CellTask task;

  /** A pool of {@code workers} threads for cells 0 to {@code cells - 1}. */
  public StreamSweeper(int workers, int cells, CellTask task) {
    threads = new ForkJoinPool(workers);
    this.cells = cells;
    this.task = task;
  }

  @Override
  public void run(int steps) {
    threads.submit(() -> sweep(steps)).join();
  }

  private void sweep(int steps) {
    for (int step = 0; step < steps; step++) {
      IntStream.range(0, cells).parallel().forEach(task::process);
    }
  }

  @Override
  public void close() {
    threads.shutdown();
  }
}
