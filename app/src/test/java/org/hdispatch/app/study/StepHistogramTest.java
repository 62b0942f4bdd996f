package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class StepHistogramTest {
  private static final double DIGITS = 1e-3; // HdrHistogram keeps three

  @Test
  void percentilesAreThoseOfTheSteps() {
    StepHistogram histogram = new StepHistogram();
    for (int micros = 1; micros <= 1000; micros++) {
      histogram.record(1000L * micros);
    }
    GcFigures.StepTimes times = histogram.times();
    assertEquals(500, times.p50Micros(), 500 * DIGITS);
    assertEquals(990, times.p99Micros(), 990 * DIGITS);
    assertEquals(999, times.p999Micros(), 999 * DIGITS);
    assertEquals(1000, times.maxMicros(), 1000 * DIGITS);
  }

  @Test
  void percentileBeyondWhichThereIsNoStepIsNotKnown() {
    StepHistogram histogram = new StepHistogram();
    histogram.record(1000);
    assertEquals(1, histogram.times().p50Micros(), DIGITS);
    for (int n = 2; n < 100; n++) {
      histogram.record(1000);
    }
    assertEquals(-1, histogram.times().p99Micros());
    histogram.record(1000);
    assertEquals(1, histogram.times().p99Micros(), DIGITS);
    for (int n = 101; n < 1000; n++) {
      histogram.record(1000);
    }
    assertEquals(-1, histogram.times().p999Micros());
    histogram.record(1000);
    assertEquals(1, histogram.times().p999Micros(), DIGITS);
  }

  @Test
  void everyStepIsInOneClassBelowItsEdge() {
    StepHistogram histogram = new StepHistogram();
    for (int n = 0; n < 90; n++) {
      histogram.record(10_000_000);
    }
    for (int n = 0; n < 10; n++) {
      histogram.record(30_000_000);
    }
    GcFigures.StepTimes times = histogram.times();
    List<Double> edges = times.edgesMicros();
    List<Long> counts = times.counts();
    assertEquals(edges.size(), counts.size());
    assertEquals(100, counts.stream().mapToLong(Long::longValue).sum());
    assertEquals(10, counts.get(counts.size() - 1));
    assertTrue(edges.get(edges.size() - 1) >= times.maxMicros());
    assertEquals(90, counts.get(0) + counts.get(1)); // where the first edge falls is a rounding
    for (int n = 1; n < edges.size(); n++) {
      assertTrue(edges.get(n) > edges.get(n - 1));
    }
  }
}
