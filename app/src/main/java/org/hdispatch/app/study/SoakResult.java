package org.hdispatch.app.study;

import java.util.Optional;

/**
 * What a JVM of the soak did.
 *
 * @param java its version
 * @param collector its collector
 * @param job what it stepped
 * @param heapBytes its heap ({@code -Xms} and {@code -Xmx})
 * @param liveBytes in use after the set-up and a full collection
 * @param verdict whether nothing was left to the collector
 * @param why in a line, why it did not pass or was left out; empty if it passed
 * @param figures what was counted; empty if the JVM did not get so far
 */
public record SoakResult(
    String java,
    Collector collector,
    SoakJob job,
    long heapBytes,
    long liveBytes,
    Verdict verdict,
    String why,
    Optional<Figures> figures) {

  /** How it ended. */
  public enum Verdict {
    /** Nothing was left to the collector. */
    PASSED,
    /** Something was, or the JVM died. */
    FAILED,
    /** This JDK does not have the collector. */
    LEFT_OUT
  }

  /**
   * What was counted after warm-up.
   *
   * @param seconds wall time
   * @param bytes allocated by all workers in all steps, or -1 if this JVM does not count
   * @param partsWithoutBytes of a hundred equal parts of the run, those in which not a byte was
   *     allocated
   * @param collections collections, as the management beans count them
   * @param collectorSafepoints stops of all threads by the collector
   * @param safepoints stops of all threads for whatever reason
   * @param stalls waits for memory
   * @param result what the steps came to
   */
  public record Figures(
      double seconds,
      long bytes,
      int partsWithoutBytes,
      long collections,
      long collectorSafepoints,
      long safepoints,
      long stalls,
      String result) {}
}
