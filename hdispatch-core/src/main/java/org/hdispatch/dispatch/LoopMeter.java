package org.hdispatch.dispatch;

import java.util.ArrayList;
import java.util.List;
import org.hdispatch.gc.AllocationMeter;

/** Adds up what the workers did while this loop ran. */
final class LoopMeter {
  private final Dispatcher dispatcher;
  private final int workers;
  private AllocationMeter allocation;
  private Thread caller;
  private final long[] bytesBefore;
  private final long[] bytes;
  private final long[] cells;
  private final long[] stolen;
  private final long[] busyNanos;
  private long steps;
  private long nanos;

  LoopMeter(Dispatcher dispatcher) {
    this.dispatcher = dispatcher;
    workers = dispatcher.workers();
    bytesBefore = new long[workers];
    bytes = new long[workers];
    cells = new long[workers];
    stolen = new long[workers];
    busyNanos = new long[workers];
  }

  void begin() {
    if (caller != Thread.currentThread()) {
      caller = Thread.currentThread();
      long[] ids = new long[workers];
      for (int id = 0; id < workers; id++) {
        ids[id] = threadId(dispatcher.thread(id));
      }
      allocation = new AllocationMeter(ids);
    }
    add(-1);
    allocation.read(bytesBefore);
  }

  @SuppressWarnings("deprecation") // threadId() needs Java 19
  private static long threadId(Thread thread) {
    return thread.getId();
  }

  void countStep() {
    steps++;
  }

  void end() {
    for (int id = 0; id < workers; id++) {
      bytes[id] -= bytesBefore[id];
    }
    allocation.read(bytesBefore);
    for (int id = 0; id < workers; id++) {
      bytes[id] += bytesBefore[id];
    }
    add(1);
  }

  private void add(int sign) {
    nanos += sign * System.nanoTime();
    for (int id = 0; id < workers; id++) {
      Worker worker = dispatcher.worker(id);
      cells[id] += sign * worker.cells();
      stolen[id] += sign * worker.stolen();
      busyNanos[id] += sign * worker.busyNanos();
    }
  }

  void reset() {
    steps = 0;
    nanos = 0;
    for (int id = 0; id < workers; id++) {
      bytes[id] = 0;
      cells[id] = 0;
      stolen[id] = 0;
      busyNanos[id] = 0;
    }
  }

  LoopStats stats() {
    List<LoopStats.WorkerStats> perWorker = new ArrayList<>();
    for (int id = 0; id < workers; id++) {
      perWorker.add(new LoopStats.WorkerStats(cells[id], stolen[id], busyNanos[id], bytes[id]));
    }
    return new LoopStats(steps, nanos, perWorker);
  }
}
