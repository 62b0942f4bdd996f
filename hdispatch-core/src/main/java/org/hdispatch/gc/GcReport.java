package org.hdispatch.gc;

import java.time.Duration;

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
 */
public record GcReport(
    String collector,
    Source source,
    long collections,
    Stops pauses,
    Stops safepoints,
    Stops stalls) {

  /** Where the figures of a report come from. */
  public enum Source {
    /** JDK Flight Recorder: all figures are measured, to the nanosecond. */
    FLIGHT_RECORDER,
    /**
     * Management beans, where Flight Recorder is not to be had: collections are right, each pause
     * is truncated to milliseconds, the longest is not known (the total stands in its place), and
     * {@link Stops#NOT_MEASURED} stands for the rest.
     */
    BEANS
  }

  /**
   * Stops of one kind.
   *
   * @param count how many began in the window, or -1 if not measured
   * @param total sum of their lengths
   * @param longest length of the longest
   */
  public record Stops(long count, Duration total, Duration longest) {

    /** No stop of this kind. */
    public static final Stops NONE = new Stops(0, Duration.ZERO, Duration.ZERO);

    /** Not known: this source does not measure stops of this kind. */
    public static final Stops NOT_MEASURED = new Stops(-1, Duration.ZERO, Duration.ZERO);

    /**
     * Whether the figures were measured at all.
     *
     * @return false for {@link #NOT_MEASURED}
     */
    public boolean measured() {
      return count >= 0;
    }

    Stops plus(Duration stop) {
      return new Stops(count + 1, total.plus(stop), stop.compareTo(longest) > 0 ? stop : longest);
    }
  }
}
