package org.hdispatch.gc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class GcWatchTest {

  private static volatile double computed;

  @Test
  void everyForcedCollectionFallsIntoItsWindow() {
    try (GcWatch watch = GcWatch.start()) {
      compute();
      watch.mark();
      System.gc();
      System.gc();
      watch.mark();
      compute();
      List<GcReport> windows = watch.stop();

      assertEquals(3, windows.size());
      assertQuiet(windows.get(0));
      assertQuiet(windows.get(2));

      GcReport forced = windows.get(1);
      assertTrue(forced.collections() >= 2, forced::toString); // Parallel counts young and full
      assertTrue(forced.pauses().count() >= 2, forced::toString);
      assertTrue(isPositive(forced.pauses().longest()), forced::toString);
      assertTrue(forced.pauses().total().compareTo(forced.pauses().longest()) > 0);
      assertEquals(0, forced.stalls().count());
    }
  }

  @Test
  void threadsAreStoppedForLongerThanTheCollectorPauses() {
    try (GcWatch watch = GcWatch.start()) {
      System.gc();
      GcReport report = watch.stop().get(0);
      assertEquals(GcReport.Source.FLIGHT_RECORDER, report.source());
      assertTrue(report.safepoints().measured());
      assertTrue(
          report.safepoints().total().compareTo(report.pauses().total()) >= 0, report::toString);
    }
  }

  @Test
  void watchesOpenAtTheSameTimeKeepTheirOwnWindows() {
    try (GcWatch outer = GcWatch.start()) {
      System.gc();
      try (GcWatch inner = GcWatch.start()) {
        inner.mark();
        compute();
        List<GcReport> windows = inner.stop();
        assertEquals(2, windows.size());
        assertQuiet(windows.get(0));
        assertQuiet(windows.get(1));
      }
      List<GcReport> windows = outer.stop();
      assertEquals(1, windows.size());
      assertTrue(windows.get(0).collections() >= 1);
    }
  }

  @Test
  void stopsOnceAndIsThenClosedToMarks() {
    GcWatch watch = GcWatch.start();
    List<GcReport> windows = watch.stop();
    assertSame(windows, watch.stop());
    watch.close();
    assertSame(windows, watch.stop());
    assertThrows(IllegalStateException.class, watch::mark);
  }

  @Test
  void reportNamesTheCollector() {
    try (GcWatch watch = GcWatch.start()) {
      assertFalse(GcWatch.collector().isBlank());
      assertEquals(GcWatch.collector(), watch.stop().get(0).collector());
    }
  }

  @Test
  void timelineHoldsThePausesInTheirOrder() {
    try (GcWatch watch = GcWatch.start()) {
      compute();
      watch.mark();
      System.gc();
      System.gc();
      GcReport report = watch.stop().get(1);
      assertEquals(report.pauses().count(), report.timeline().size());
      Duration before = Duration.ZERO;
      Duration total = Duration.ZERO;
      for (GcReport.Pause pause : report.timeline()) {
        assertTrue(pause.at().compareTo(before) > 0, report::toString);
        assertFalse(pause.name().isBlank());
        before = pause.at();
        total = total.plus(pause.length());
      }
      assertEquals(report.pauses().total(), total);
      assertTrue(isPositive(report.reaching()));
      assertTrue(report.safepoints().total().compareTo(report.reaching()) > 0);
      assertTrue(report.peakHeapBytes() > 0);
    }
  }

  @Test
  void p99IsTheLeastThatNinetyNineOfAHundredDoNotExceed() {
    List<Duration> lengths = new ArrayList<>();
    for (int n = 200; n >= 1; n--) {
      lengths.add(Duration.ofNanos(n));
    }
    GcReport.Stops stops = GcReport.Stops.of(lengths);
    assertEquals(
        new GcReport.Stops(
            200, Duration.ofNanos(20_100), Duration.ofNanos(198), Duration.ofNanos(200)),
        stops);
    assertEquals(Duration.ofNanos(7), GcReport.Stops.of(List.of(Duration.ofNanos(7))).p99());
  }

  @Test
  void beansCountTheSameForcedCollections() {
    List<GcReport> windows;
    try (GcWatch watch = GcWatch.startCounting()) {
      watch.mark();
      System.gc();
      watch.mark();
      windows = watch.stop();
    }
    assertEquals(3, windows.size());
    GcReport report = windows.get(1);
    assertEquals(GcReport.Source.BEANS, report.source());
    assertTrue(report.collections() >= 1, report::toString);
    assertTrue(report.pauses().count() >= 1, report::toString);
    assertFalse(report.safepoints().measured());
    assertFalse(report.stalls().measured());
  }

  private static void assertQuiet(GcReport report) {
    assertEquals(0, report.collections(), report::toString);
    assertEquals(GcReport.Stops.NONE, report.pauses(), report::toString);
    assertEquals(GcReport.Stops.NONE, report.stalls(), report::toString);
  }

  private static boolean isPositive(Duration duration) {
    return duration.compareTo(Duration.ZERO) > 0;
  }

  private static void compute() {
    double sum = 0;
    for (int i = 0; i < 10_000_000; i++) {
      sum += Math.sqrt(i);
    }
    computed = sum;
  }
}
