package org.hdispatch.app.draw;

import java.util.List;
import java.util.function.DoubleFunction;

/** An axis of a plot. */
public interface PlotAxis {
  /** What it shows, with its unit. */
  String title();

  /** Value at its beginning. */
  double least();

  /** Value at its end. */
  double most();

  /** The text for a value. */
  DoubleFunction<String> label();

  /** Values that get a number, ascending. */
  List<Double> ticks();

  /** Place of a value: 0 at the beginning or before, 1 at the end or after. */
  double place(double value);
}
