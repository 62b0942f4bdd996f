package org.hdispatch.dispatch;

import java.util.List;
import java.util.Locale;

/**
 * What a loop has done.
 *
 * @param steps steps completed
 * @param nanos wall time spent in them, ns
 * @param workers what each worker did; worker 0 is the caller's thread
 */
public record LoopStats(long steps, long nanos, List<WorkerStats> workers) {

  /** Stands for bytes that this JVM does not count, as on virtual threads or ended ones. */
  public static final long NOT_MEASURED = -1;

  /**
   * What one worker did.
   *
   * @param cells cells processed, all passes counted
   * @param stolen those of them that came from another worker's home segment
   * @param busyNanos wall time from the first to the last cell of each pass, ns
   * @param allocatedBytes bytes allocated by its thread while the loop ran, or {@link
   *     #NOT_MEASURED}
   */
  public record WorkerStats(long cells, long stolen, long busyNanos, long allocatedBytes) {}

  /** Keeps a copy of the list. */
  public LoopStats {
    workers = List.copyOf(workers);
  }

  /** Share of the workers' time in which they had cells: 1 is ideal, 0 before the first step. */
  public double efficiency() {
    if (nanos == 0) {
      return 0;
    }
    long busy = workers.stream().mapToLong(WorkerStats::busyNanos).sum();
    return (double) busy / nanos / workers.size();
  }

  /**
   * Bytes that the worst worker allocated per step, rounded up; 0 before the first step, {@link
   * #NOT_MEASURED} if those of a worker are not known.
   */
  public long bytesPerStep() {
    if (workers.stream().anyMatch(worker -> worker.allocatedBytes() < 0)) {
      return NOT_MEASURED;
    }
    long most = workers.stream().mapToLong(WorkerStats::allocatedBytes).max().orElse(0);
    return steps == 0 ? 0 : (most + steps - 1) / steps;
  }

  /** One line: steps, time per step, efficiency, bytes per step. */
  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%d steps, %.3g us each, %d workers %.1f %% busy, %s bytes allocated per step",
        steps,
        steps == 0 ? 0 : nanos * 1e-3 / steps,
        workers.size(),
        100 * efficiency(),
        bytesPerStep() < 0 ? "unknown" : bytesPerStep());
  }
}
