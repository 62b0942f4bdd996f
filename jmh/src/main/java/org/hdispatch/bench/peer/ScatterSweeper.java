package org.hdispatch.bench.peer;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;

/**
 * Threads that own a fixed part of the cells each, with no tickets at all, and a barrier that spins
 * without end: the caller, one of them, waits for every thread, whether it was scheduled or not.
 */
public final class ScatterSweeper implements Sweeper {
  private static final VarHandle WORD = MethodHandles.arrayElementVarHandle(long[].class);

  /** Longs between two hot words: 128 bytes, as in the dispatcher. */
  private static final int STRIDE = 16;

  private static final long CLOSED = -1;

  private final int workers;
  private final int cells;
  private final CellTask task;

  /** The step that is open, then the step that each worker has done. */
  private final long[] words;

  private long step;

  /** Starts {@code workers - 1} threads for cells 0 to {@code cells - 1}. */
  public ScatterSweeper(int workers, int cells, CellTask task) {
    this.workers = workers;
    this.cells = cells;
    this.task = task;
    words = new long[(workers + 2) * STRIDE];
    for (int id = 1; id < workers; id++) {
      int worker = id;
      Thread thread = new Thread(() -> work(worker), "scatter-" + id);
      thread.setDaemon(true);
      thread.start();
    }
  }

  @Override
  public void run(int steps) {
    for (int n = 0; n < steps; n++) {
      step++;
      WORD.setRelease(words, opened(), step);
      sweep(0);
      for (int worker = 1; worker < workers; worker++) {
        while ((long) WORD.getAcquire(words, done(worker)) != step) {
          Thread.onSpinWait();
        }
      }
    }
  }

  private void work(int worker) {
    long last = 0;
    while (true) {
      long open = (long) WORD.getAcquire(words, opened());
      if (open == CLOSED) {
        return;
      }
      if (open == last) {
        Thread.onSpinWait();
        continue;
      }
      sweep(worker);
      last = open;
      WORD.setRelease(words, done(worker), last);
    }
  }

  private void sweep(int worker) {
    int end = begin(worker + 1);
    for (int cell = begin(worker); cell < end; cell++) {
      task.process(cell);
    }
  }

  private int begin(int worker) {
    return (int) ((long) cells * worker / workers);
  }

  private static int opened() {
    return STRIDE;
  }

  private static int done(int worker) {
    return (worker + 1) * STRIDE;
  }

  @Override
  public void close() {
    WORD.setRelease(words, opened(), CLOSED);
  }
}
