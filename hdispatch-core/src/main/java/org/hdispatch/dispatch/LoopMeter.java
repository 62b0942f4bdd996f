package org.hdispatch.dispatch;

import java.util.ArrayList;
import java.util.List;
import org.hdispatch.gc.AllocationMeter;

/** Adds up what the workers did while a loop ran, run by run. */
final class LoopMeter {
  private final Crew crew;
  private final Counters atBegin;
  private final Counters now;
  private final Counters total;
  private final long[] bytes;
  private AllocationMeter allocation; // null if this JVM does not count
  private Thread caller;
  private boolean bytesMeasured = true;
  private long steps;

  LoopMeter(Crew crew) {
    this.crew = crew;
    atBegin = new Counters(crew.size());
    now = new Counters(crew.size());
    total = new Counters(crew.size());
    bytes = new long[crew.size()];
  }

  /** Readings of all workers, or differences of them. */
  private static final class Counters {
    long nanos;
    final long[] bytes;
    final long[] cells;
    final long[] stolen;
    final long[] busyNanos;

    Counters(int workers) {
      bytes = new long[workers];
      cells = new long[workers];
      stolen = new long[workers];
      busyNanos = new long[workers];
    }
  }

  /** A run begins. */
  void begin() {
    if (caller != Thread.currentThread()) {
      caller = Thread.currentThread();
      allocation = newAllocationMeter();
    }
    read(atBegin);
  }

  /** A run has ended, after this many whole steps. */
  void end(long stepsDone) {
    read(now);
    steps += stepsDone;
    total.nanos += now.nanos - atBegin.nanos;
    for (int id = 0; id < total.cells.length; id++) {
      total.cells[id] += now.cells[id] - atBegin.cells[id];
      total.stolen[id] += now.stolen[id] - atBegin.stolen[id];
      total.busyNanos[id] += now.busyNanos[id] - atBegin.busyNanos[id];
      total.bytes[id] += now.bytes[id] - atBegin.bytes[id];
      bytesMeasured &= now.bytes[id] >= 0 && atBegin.bytes[id] >= 0;
    }
  }

  private void read(Counters into) {
    into.nanos = System.nanoTime();
    for (int id = 0; id < into.cells.length; id++) {
      Worker worker = crew.worker(id);
      into.cells[id] = worker.cells();
      into.stolen[id] = worker.stolen();
      into.busyNanos[id] = worker.busyNanos();
      into.bytes[id] = -1;
    }
    if (allocation != null) {
      allocation.read(into.bytes);
    }
  }

  /** Bytes that all workers have allocated in their lives; the same each time if not measured. */
  long allocatedBytes() {
    long sum = 0;
    if (allocation != null) {
      allocation.read(bytes);
      for (long each : bytes) {
        sum += each;
      }
    }
    return sum;
  }

  private AllocationMeter newAllocationMeter() {
    long[] ids = new long[crew.size()];
    for (int id = 0; id < ids.length; id++) {
      ids[id] = threadId(crew.thread(id));
    }
    try {
      return new AllocationMeter(ids);
    } catch (UnsupportedOperationException e) {
      return null; // the statistics say "not measured"; stepping needs no meter
    }
  }

  @SuppressWarnings("deprecation") // threadId() needs Java 19
  private static long threadId(Thread thread) {
    return thread.getId();
  }

  void reset() {
    steps = 0;
    bytesMeasured = true;
    total.nanos = 0;
    for (int id = 0; id < total.cells.length; id++) {
      total.bytes[id] = 0;
      total.cells[id] = 0;
      total.stolen[id] = 0;
      total.busyNanos[id] = 0;
    }
  }

  LoopStats stats() {
    List<LoopStats.WorkerStats> perWorker = new ArrayList<>();
    for (int id = 0; id < total.cells.length; id++) {
      perWorker.add(
          new LoopStats.WorkerStats(
              total.cells[id],
              total.stolen[id],
              total.busyNanos[id],
              bytesMeasured ? total.bytes[id] : LoopStats.NOT_MEASURED));
    }
    return new LoopStats(steps, total.nanos, perWorker);
  }
}
