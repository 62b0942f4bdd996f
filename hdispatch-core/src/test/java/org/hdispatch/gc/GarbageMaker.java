package org.hdispatch.gc;

import java.util.List;
import java.util.stream.Collectors;

/** A program that makes garbage while it is watched, and prints what the watch has seen. */
final class GarbageMaker {
  private static final int LIVE = 20_000; // arrays that are kept: 20 MB
  private static final int ARRAY = 1000;
  private static final long NANOS = 900_000_000;

  private GarbageMaker() {}

  /** Prints begin and end of the window on the clock of the log, then a line for each figure. */
  public static void main(String[] args) {
    byte[][] live = new byte[LIVE][];
    try (GcWatch watch = GcWatch.start()) {
      long begin = System.nanoTime();
      long end = begin;
      for (long n = 0; end - begin < NANOS; n++) {
        live[(int) (n * 7919 % LIVE)] = new byte[ARRAY];
        if (n % 64 == 0) {
          end = System.nanoTime();
        }
      }
      System.gc();
      end = System.nanoTime();
      List<GcReport> windows = watch.stop();
      GcReport report = windows.get(0);
      System.out.println("begin " + begin);
      System.out.println("end " + end);
      System.out.println("pauses " + report.pauses().count());
      System.out.println("pauseNanos " + report.pauses().total().toNanos());
      System.out.println("pauseP99Nanos " + report.pauses().p99().toNanos());
      System.out.println("pauseLongestNanos " + report.pauses().longest().toNanos());
      System.out.println("safepoints " + report.safepoints().count());
      System.out.println("safepointNanos " + report.safepoints().total().toNanos());
      System.out.println("reachingNanos " + report.reaching().toNanos());
      System.out.println(
          "timeline "
              + report.timeline().stream()
                  .map(pause -> Long.toString(pause.length().toNanos()))
                  .collect(Collectors.joining(",")));
      System.out.println("peakHeapBytes " + report.peakHeapBytes());
      System.out.println("kept " + live.length);
    }
  }
}
