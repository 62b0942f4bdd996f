package org.hdispatch.bench.peer;

import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.CyclicBarrier;

/**
 * Threads that take cells from one shared supply and meet at a {@code CyclicBarrier} before and
 * after each step. The caller is one of them.
 */
public final class BarrierSweeper implements Sweeper {
  private final CyclicBarrier barrier;
  private final Supply supply;
  private final CellTask task;
  private volatile boolean closed;

  /** Where the threads take cells from. */
  interface Supply {
    /** Lays out the cells of a step; called by one thread while the others wait. */
    void refill();

    /** Takes a cell: its number, or a negative one if none is left. */
    int take();
  }

  private BarrierSweeper(int workers, Supply supply, CellTask task) {
    barrier = new CyclicBarrier(workers);
    this.supply = supply;
    this.task = task;
    for (int id = 1; id < workers; id++) {
      Thread thread = new Thread(this::work, "barrier-" + id);
      thread.setDaemon(true);
      thread.start();
    }
  }

  /**
   * Starts {@code workers - 1} threads that count through cells 0 to {@code cells - 1}: the
   * dispatcher as one would write it in an afternoon.
   */
  public static BarrierSweeper overCounter(int workers, int cells, CellTask task) {
    return new BarrierSweeper(workers, new SharedCounter(cells), task);
  }

  /**
   * Starts {@code workers - 1} threads that poll the keys of cells 0 to {@code cells - 1} from a
   * queue: the naive queue of events.
   */
  public static BarrierSweeper overQueue(int workers, int cells, CellTask task) {
    return new BarrierSweeper(workers, new QueueOfKeys(cells), task);
  }

  @Override
  public void run(int steps) {
    for (int step = 0; step < steps; step++) {
      supply.refill();
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
    for (int cell = supply.take(); cell >= 0; cell = supply.take()) {
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
