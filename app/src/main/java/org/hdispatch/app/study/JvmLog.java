package org.hdispatch.app.study;

import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What a JVM's log says of a window of time: exact, and at no cost to the heap.
 *
 * @param safepoints stops of all threads, for whatever reason
 * @param collectorSafepoints those of them that were the collector's; what is not known to be
 *     somebody else's is taken for the collector's
 * @param stalls waits of single threads for memory, under ZGC
 */
record JvmLog(long safepoints, long collectorSafepoints, long stalls) {
  private static final Pattern LINE = Pattern.compile("\\[(\\d+)ns\\] ?(.*)");
  private static final Pattern SAFEPOINT = Pattern.compile("Safepoint \"([^\"]+)\".*");
  private static final Pattern STALL = Pattern.compile(".*(Allocation|Relocation) Stall \\(.*");

  /** Reasons to stop all threads that have nothing to do with the heap. */
  private static final Set<String> OTHERS =
      Set.of(
          "BulkRevokeBias",
          "Cleanup",
          "Deoptimize",
          "DeoptimizeAll",
          "DeoptimizeFrame",
          "EnableBiasedLocking",
          "ForceSafepoint",
          "ICBufferFull",
          "None",
          "RevokeBias");

  /** The option that makes a JVM write such a log, with the time of {@link System#nanoTime}. */
  static String option(String file) {
    return "-Xlog:gc,safepoint:file=" + file + ":timenanos:filecount=0";
  }

  /**
   * Reads a log.
   *
   * @param from begin of the window, as {@link System#nanoTime} told it
   * @param to its end
   */
  static JvmLog of(Stream<String> lines, long from, long to) {
    long stalls = 0;
    long all = 0;
    long collectors = 0;
    for (String line : (Iterable<String>) lines::iterator) {
      Matcher matcher = LINE.matcher(line);
      if (matcher.matches() && from <= time(matcher) && time(matcher) <= to) {
        String message = matcher.group(2);
        Matcher safepoint = SAFEPOINT.matcher(message);
        if (safepoint.matches()) {
          all++;
          collectors += OTHERS.contains(safepoint.group(1)) ? 0 : 1;
        }
        stalls += STALL.matcher(message).matches() ? 1 : 0;
      }
    }
    return new JvmLog(all, collectors, stalls);
  }

  private static long time(Matcher line) {
    return Long.parseLong(line.group(1));
  }
}
