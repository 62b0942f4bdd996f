package org.hdispatch.app.study;

import java.util.List;

/**
 * What was measured in a run after warm-up.
 *
 * @param heapBytes size of the heap ({@code -Xms} and {@code -Xmx})
 * @param peakHeapBytes most of it in use, as seen at collections and at the end
 * @param workers threads that stepped
 * @param cells processed in a step
 * @param steps number of them
 * @param seconds wall time
 * @param workerCpuSeconds processor time of the threads that stepped
 * @param otherCpuSeconds of all other threads: the collector's, the compilers', the recorder's
 * @param collectorCpuSeconds the collector's share of that, or -1 where the operating system does
 *     not tell
 * @param collections collections begun; a concurrent cycle counts once
 * @param pauses stop-the-world work of the collector, as it reports it
 * @param stopped all threads stopped, for whatever reason, from the request until they ran again
 * @param reachingMillis share of that until all threads had stopped (time to safepoint), ms
 * @param stalls single threads held up for memory (ZGC)
 * @param stepTimes lengths of the steps
 * @param bytesPerStep allocated by the worst worker, or -1 if not measured
 * @param bytesPerStepInAll allocated by all threads that stepped, or -1 if not measured
 * @param timeline the pauses one by one, in order
 */
public record GcFigures(
    long heapBytes,
    long peakHeapBytes,
    int workers,
    int cells,
    long steps,
    double seconds,
    double workerCpuSeconds,
    double otherCpuSeconds,
    double collectorCpuSeconds,
    long collections,
    Stops pauses,
    Stops stopped,
    double reachingMillis,
    Stops stalls,
    StepTimes stepTimes,
    double bytesPerStep,
    double bytesPerStepInAll,
    List<Pause> timeline) {

  /**
   * Stops of one kind.
   *
   * @param count number of them, or -1 if not measured
   * @param totalMillis sum, ms
   * @param p99Millis 99th percentile, ms
   * @param maxMillis longest, ms
   */
  public record Stops(long count, double totalMillis, double p99Millis, double maxMillis) {}

  /**
   * A stop-the-world pause.
   *
   * @param atSeconds when it began, after the first measured step, s
   * @param millis its length, ms
   * @param kind what the collector calls it
   */
  public record Pause(double atSeconds, double millis, String kind) {}

  /**
   * Lengths of the steps, with their histogram.
   *
   * @param p50Micros median, us
   * @param p99Micros 99th percentile, us; -1 if steps are fewer than 100
   * @param p999Micros 99.9th percentile, us; -1 if steps are fewer than 1000
   * @param maxMicros longest, us
   * @param edgesMicros upper edges of the classes, us, ascending; shape: [classes]
   * @param counts steps in each class; shape: [classes]
   */
  public record StepTimes(
      double p50Micros,
      double p99Micros,
      double p999Micros,
      double maxMicros,
      List<Double> edgesMicros,
      List<Long> counts) {

    /** Number of steps. */
    public long steps() {
      return counts.stream().mapToLong(Long::longValue).sum();
    }

    /** 90th percentile, us: the upper edge of its class, 0 without steps. */
    public double p90Micros() {
      long below = 0;
      for (int n = 0; n < counts.size(); n++) {
        below += counts.get(n);
        if (below > 0 && below >= 0.9 * steps()) {
          return edgesMicros.get(n);
        }
      }
      return 0;
    }
  }
}
