package org.hdispatch.gc;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;

/**
 * What the garbage collector did in one window of a run.
 *
 * @param collector name of the collector, such as {@code G1}
 * @param source where the figures come from
 * @param collections collections begun in the window; a concurrent cycle counts once, however many
 *     pauses it has
 * @param pauses stop-the-world work as the collector reports it
 * @param safepoints stops of all threads for whatever reason, from the request until they ran again
 * @param stalls waits of single threads for memory, under ZGC; stalls of several threads at the
 *     same time are added up
 * @param reaching share of the safepoints from the request until all threads had stopped (time to
 *     safepoint)
 * @param timeline the pauses one by one, in the order in which they began; empty if not measured
 * @param peakHeapBytes most of the heap in use before or after a collection, or -1 if no collection
 *     told
 */
public record GcReport(
    String collector,
    Source source,
    long collections,
    Stops pauses,
    Stops safepoints,
    Stops stalls,
    Duration reaching,
    List<Pause> timeline,
    long peakHeapBytes) {

  /** Keeps a copy of the pauses. */
  public GcReport {
    timeline = List.copyOf(timeline);
  }

  /** Where the figures of a report come from. */
  public enum Source {
    /** JDK Flight Recorder: all figures are measured, to the nanosecond. */
    FLIGHT_RECORDER,
    /**
     * Management beans, where Flight Recorder is not to be had or not wanted: collections are
     * right, each pause is truncated to milliseconds, lengths of single pauses are not known (the
     * total stands in place of the longest), and {@link Stops#NOT_MEASURED} stands for the rest.
     */
    BEANS
  }

  /**
   * Stops of one kind.
   *
   * @param count how many began in the window, or -1 if not measured
   * @param total sum of their lengths
   * @param p99 99th percentile of their lengths: the least that 99 % of them do not exceed
   * @param longest length of the longest
   */
  public record Stops(long count, Duration total, Duration p99, Duration longest) {
    private static final int PERCENT = 99;

    /** No stop of this kind. */
    public static final Stops NONE = new Stops(0, Duration.ZERO, Duration.ZERO, Duration.ZERO);

    /** Not known: this source does not measure stops of this kind. */
    public static final Stops NOT_MEASURED =
        new Stops(-1, Duration.ZERO, Duration.ZERO, Duration.ZERO);

    /**
     * Whether the figures were measured at all.
     *
     * @return false for {@link #NOT_MEASURED}
     */
    public boolean measured() {
      return count >= 0;
    }

    /** Stops of these lengths, in any order. */
    static Stops of(List<Duration> lengths) {
      if (lengths.isEmpty()) {
        return NONE;
      }
      Duration[] sorted = lengths.toArray(Duration[]::new);
      Arrays.sort(sorted);
      int rank = (PERCENT * sorted.length + 99) / 100;
      Duration total = Duration.ZERO;
      for (Duration each : sorted) {
        total = total.plus(each);
      }
      return new Stops(sorted.length, total, sorted[rank - 1], sorted[sorted.length - 1]);
    }
  }

  /**
   * One stop-the-world pause.
   *
   * @param at when it began, after the begin of the window
   * @param length how long it lasted
   * @param name what the collector calls it
   */
  public record Pause(Duration at, Duration length, String name) {}
}
