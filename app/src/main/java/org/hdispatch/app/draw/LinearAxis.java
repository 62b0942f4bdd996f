package org.hdispatch.app.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import org.hdispatch.app.text.Numbers;

/**
 * An axis from zero, on which equal distances are equal differences.
 *
 * @param title what it shows, with its unit
 * @param most value at its end; positive
 */
public record LinearAxis(String title, double most) implements PlotAxis {
  private static final int TICKS = 5; // at most
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
    double distance = tickDistance(most);
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

  /** The distance of ticks that are easy to read: 1, 2 or 5 times a power of ten. */
  public static double tickDistance(double highest) {
    double power = Math.pow(10, Math.floor(Math.log10(highest / TICKS)));
    for (double factor : new double[] {1, 2, 5}) {
      if (highest <= TICKS * factor * power) {
        return factor * power;
      }
    }
    return 10 * power;
  }
}
