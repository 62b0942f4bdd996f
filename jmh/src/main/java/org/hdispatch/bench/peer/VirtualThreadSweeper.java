package org.hdispatch.bench.peer;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * A virtual thread per cell, made anew in each step. The caller waits, parked, for the last of
 * them; they count themselves done, which is cheaper than a future each.
 *
 * <p>Needs JDK 21. The JVM's scheduler has as many threads as the machine has processors, or as
 * {@code -Djdk.virtualThreadScheduler.parallelism} says.
 */
public final class VirtualThreadSweeper implements Sweeper {
  private final ExecutorService threads;
  private final Runnable[] tasks;
  private final AtomicInteger pending = new AtomicInteger();
  private volatile Thread caller;

  /**
   * An executor for cells 0 to {@code cells - 1}.
   *
   * @throws UnavailablePeerException before JDK 21
   * @throws IllegalArgumentException if {@code workers} is not the scheduler's number of threads
   */
  public VirtualThreadSweeper(int workers, int cells, CellTask task) {
    threads = newExecutor();
    int all =
        Integer.getInteger(
            "jdk.virtualThreadScheduler.parallelism", Runtime.getRuntime().availableProcessors());
    if (workers != all) {
      throw new IllegalArgumentException(
          "workers must be all of the scheduler of virtual threads (set"
              + " -Djdk.virtualThreadScheduler.parallelism=workers): workers="
              + workers
              + ", all="
              + all);
    }
    tasks = new Runnable[cells];
    for (int n = 0; n < cells; n++) {
      int cell = n;
      tasks[n] =
          () -> {
            task.process(cell);
            if (pending.decrementAndGet() == 0) {
              LockSupport.unpark(caller);
            }
          };
    }
  }

  /** {@code Executors.newVirtualThreadPerTaskExecutor()}, which Java 17 has no name for. */
  private static ExecutorService newExecutor() {
    try {
      MethodHandle made =
          MethodHandles.publicLookup()
              .findStatic(
                  Executors.class,
                  "newVirtualThreadPerTaskExecutor",
                  MethodType.methodType(ExecutorService.class));
      return (ExecutorService) made.invokeExact();
    } catch (NoSuchMethodException e) {
      throw new UnavailablePeerException(
          "virtual threads need JDK 21 or newer: java=" + Runtime.version().feature());
    } catch (Throwable e) { // what invokeExact declares
      throw new IllegalStateException("executor of virtual threads must start", e);
    }
  }

  @Override
  public void run(int steps) {
    caller = Thread.currentThread();
    for (int step = 0; step < steps; step++) {
      pending.set(tasks.length);
      for (Runnable each : tasks) {
        threads.execute(each);
      }
      while (pending.get() != 0) {
        LockSupport.park(this);
      }
    }
  }

  @Override
  public void close() {
    threads.shutdown();
  }
}
