package org.hdispatch.bench.peer;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * {@code ExecutorService.invokeAll} with a task per cell on a fixed number of threads: the textbook
 * form. The caller waits; the tasks are made once, the futures anew in each step.
 */
public final class InvokeAllSweeper implements Sweeper {
  private final ExecutorService threads;
  private final List<Callable<Void>> tasks = new ArrayList<>();

  /** An executor of {@code workers} threads for cells 0 to {@code cells - 1}. */
  public InvokeAllSweeper(int workers, int cells, CellTask task) {
    threads = Executors.newFixedThreadPool(workers);
    for (int n = 0; n < cells; n++) {
      int cell = n;
      tasks.add(
          () -> {
            task.process(cell);
            return null;
          });
    }
  }

  @Override
  public void run(int steps) {
    try {
      for (int step = 0; step < steps; step++) {
        for (Future<Void> done : threads.invokeAll(tasks)) {
          done.get();
        }
      }
    } catch (InterruptedException | ExecutionException e) {
      throw new IllegalStateException("step must end without failure", e);
    }
  }

  @Override
  public void close() {
    threads.shutdown();
  }
}
