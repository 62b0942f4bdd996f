package org.hdispatch.app;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;

/**
 * An axis from zero, on which equal distances are equal differences.
 *
 * @param title what it shows, with its unit
 * @param most value at its end; positive
 */
record LinearAxis(String title, double most) implements PlotAxis {
  private static final double WITHIN = 1 + 1e-9; // rounding

  @Override
  public double least() {
    return 0;
  }

  @Override
  public DoubleFunction<String> label() {
    return value -> Numbers.plain(value, 3);
  }

  @Override
  public List<Double> ticks() {
    double distance = SweepPlot.tickDistance(most);
    List<Double> ticks = new ArrayList<>();
    for (int n = 0; n * distance <= most * WITHIN; n++) {
      ticks.add(n * distance);
    }
    return ticks;
  }

  @Override
  public double place(double value) {
    return Math.max(0, Math.min(1, value / most));
  }
}
