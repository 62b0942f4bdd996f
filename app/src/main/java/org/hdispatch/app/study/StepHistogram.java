package org.hdispatch.app.study;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.HdrHistogram.Histogram;
import org.HdrHistogram.HistogramIterationValue;

/** Collects lengths of steps, to three digits; recording allocates nothing. */
final class StepHistogram {
  private static final int DIGITS = 3;
  private static final long LONGEST = TimeUnit.MINUTES.toNanos(10);
  private static final double MICRO = 1e-3; // of a nanosecond

  /** From one edge of the classes to the next. */
  private static final double RATIO = 1.1;

  private final Histogram histogram = new Histogram(LONGEST, DIGITS);

  void record(long nanos) {
    histogram.recordValue(Math.min(nanos, LONGEST));
  }

  /** Percentiles, and classes in a geometric sequence from the shortest step to the longest. */
  GcFigures.StepTimes times() {
    List<Double> edges = new ArrayList<>();
    List<Long> counts = new ArrayList<>();
    double edge = Math.max(1, histogram.getMinValue()) * MICRO;
    long count = 0;
    for (HistogramIterationValue each : histogram.recordedValues()) {
      double micros = each.getValueIteratedTo() * MICRO;
      while (micros > edge) {
        if (count > 0 || !edges.isEmpty()) {
          edges.add(edge);
          counts.add(count);
        }
        count = 0;
        edge *= RATIO;
      }
      count += each.getCountAddedInThisIterationStep();
    }
    edges.add(edge);
    counts.add(count);
    return new GcFigures.StepTimes(
        micros(50, 1),
        micros(99, 100),
        micros(99.9, 1000),
        histogram.getMaxValue() * MICRO,
        edges,
        counts);
  }

  /** A percentile; -1 of fewer steps than that. */
  private double micros(double percentile, long least) {
    return histogram.getTotalCount() < least
        ? -1
        : histogram.getValueAtPercentile(percentile) * MICRO;
  }
}
