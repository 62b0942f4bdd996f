package org.hdispatch.bench.peer;

import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Threads that pull cell numbers from one shared counter and meet at a barrier before and after
 * each step: the dispatcher as one would write it in an afternoon. The caller is one of them.
 */
public final class BarrierSweeper implements Sweeper {
  private final CyclicBarrier barrier;
  private final AtomicInteger next = new AtomicInteger();
  private final int cells;
  private final CellTask task;
  private volatile boolean closed;

  /** Starts {@code workers - 1} threads for cells 0 to {@code cells - 1}. */
  public BarrierSweeper(int workers, int cells, CellTask task) {
    barrier = new CyclicBarrier(workers);
    this.cells = cells;
    this.task = task;
    for (int id = 1; id < workers; id++) {
      Thread thread = new Thread(this::work, "barrier-" + id);
      thread.setDaemon(true);
      thread.start();
    }
  }

  @Override
  public void run(int steps) {
    for (int step = 0; step < steps; step++) {
      next.set(0);
      await();
      pull();
      await();
    }
  }

  private void work() {
    while (true) {
      await();
      if (closed) {
        return;
      }
      pull();
      await();
    }
  }

  private void pull() {
    for (int cell = next.getAndIncrement(); cell < cells; cell = next.getAndIncrement()) {
      task.process(cell);
    }
  }

  private void await() {
    try {
      barrier.await();
    } catch (InterruptedException | BrokenBarrierException e) {
      throw new IllegalStateException("threads must meet at the barrier", e);
    }
  }

  @Override
  public void close() {
    closed = true;
    await();
  }
}
