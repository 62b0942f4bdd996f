package org.hdispatch.app.draw;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import org.hdispatch.app.draw.SvgWriter.Anchor;
import org.hdispatch.app.draw.SvgWriter.Mark;

/**
 * A plot on two logarithmic axes, small enough for a phone. What lies outside of the axes is drawn
 * on their edge; so is what a logarithm does not know, zero.
 */
public final class LogPlot {
  private static final int LEFT = 66;
  private static final int RIGHT = 24;
  private static final int TOP = 32;
  private static final int BOTTOM = 46;
  private static final int WIDTH = 420;
  private static final int HEIGHT = 300;
  private static final int SAMPLE = 22; // length of a line in the legend

  /** Pixels by which a curve must go on for another point to be drawn. */
  private static final double VISIBLE = 0.4;

  /** Decades from which on only powers of ten have numbers. */
  private static final double MANY_DECADES = 2.2;

  private final Scale x;
  private final Scale y;
  private final SvgWriter svg;
  private int legendAt = LEFT;

  /**
   * An axis.
   *
   * @param title what it shows, with its unit
   * @param least value at its beginning
   * @param most value at its end
   * @param label the text for a value
   */
  public record Scale(String title, double least, double most, DoubleFunction<String> label)
      implements PlotAxis {
    /**
     * From the nearest 1, 2 or 5 times a power of ten below some values to the nearest above.
     *
     * @throws IllegalArgumentException if a value is not positive
     */
    public static Scale around(
        String title, double lowest, double highest, DoubleFunction<String> label) {
      if (!(lowest > 0 && highest >= lowest && highest < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException(
            "values must be positive: lowest=" + lowest + ", highest=" + highest);
      }
      double from = 1;
      double to = 1;
      for (double tick : ticks(lowest / 10, highest * 10, true)) {
        from = tick <= lowest * (1 + 1e-9) ? tick : from;
      }
      List<Double> all = ticks(lowest / 10, highest * 10, true);
      for (int n = all.size() - 1; n >= 0; n--) {
        to = all.get(n) >= highest * (1 - 1e-9) && all.get(n) > from ? all.get(n) : to;
      }
      return new Scale(title, from, to, label);
    }

    /** Whole decades, from the one that begins below some values to the one that ends above. */
    public static Scale decades(
        String title, double lowest, double highest, DoubleFunction<String> label) {
      double from = Math.floor(Math.log10(lowest) - 1e-9);
      double to = Math.max(from + 1, Math.ceil(Math.log10(highest) - 1e-9));
      return new Scale(title, Math.pow(10, from), Math.pow(10, to), label);
    }

    /** Powers of ten within, and 2 and 5 times such if there would be too few or all are asked. */
    private static List<Double> ticks(double from, double to, boolean all) {
      List<Double> ticks = new ArrayList<>();
      for (int power = (int) Math.floor(Math.log10(from)); Math.pow(10, power) <= to; power++) {
        for (int factor : all ? new int[] {1, 2, 5} : new int[] {1}) {
          double tick = Double.parseDouble(factor + "e" + power); // exact, as it is printed
          if (tick >= from * (1 - 1e-9) && tick <= to * (1 + 1e-9)) {
            ticks.add(tick);
          }
        }
      }
      return ticks;
    }

    @Override
    public List<Double> ticks() {
      return ticks(least, most, Math.log10(most / least) < MANY_DECADES);
    }

    @Override
    public double place(double value) {
      double place = Math.log(value / least) / Math.log(most / least);
      return place > 0 ? Math.min(1, place) : 0; // -infinity and NaN included
    }
  }

  /**
   * A plot with nothing in it.
   *
   * @param title what it shows, for those who cannot see it
   * @param x axis to the right
   * @param y axis upwards
   */
  public LogPlot(String title, Scale x, Scale y) {
    this.x = x;
    this.y = y;
    svg = new SvgWriter(WIDTH, HEIGHT, title);
    axes();
  }

  private double right(double value) {
    return LEFT + (WIDTH - LEFT - RIGHT) * x.place(value);
  }

  private double down(double value) {
    return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * y.place(value);
  }

  private void axes() {
    int bottom = HEIGHT - BOTTOM;
    int end = WIDTH - RIGHT;
    for (double tick : x.ticks()) {
      svg.line(right(tick), TOP, right(tick), bottom + 5, PlotInk.PALE.light(), "");
      svg.text(right(tick), bottom + 19, x.label().apply(tick), Anchor.MIDDLE, 0);
    }
    for (double tick : y.ticks()) {
      svg.line(LEFT - 5, down(tick), end, down(tick), PlotInk.PALE.light(), "");
      svg.text(LEFT - 9, down(tick) + 4, y.label().apply(tick), Anchor.END, 0);
    }
    svg.line(LEFT, bottom, end, bottom, PlotInk.GREY.light(), "");
    svg.line(LEFT, TOP, LEFT, bottom, PlotInk.GREY.light(), "");
    svg.text((LEFT + end) / 2.0, HEIGHT - 8, x.title(), Anchor.MIDDLE, 0);
    svg.text(13, (TOP + bottom) / 2.0, y.title(), Anchor.MIDDLE, -90);
  }

  /** A curve through these points. */
  public void curve(double[] xs, double[] ys, PlotInk ink, String dashes) {
    double[] placesX = new double[xs.length];
    double[] placesY = new double[xs.length];
    int count = 0;
    for (int n = 0; n < xs.length; n++) {
      double px = right(xs[n]);
      double py = down(ys[n]);
      boolean seen =
          count == 0
              || n == xs.length - 1
              || Math.abs(px - placesX[count - 1]) + Math.abs(py - placesY[count - 1]) >= VISIBLE;
      if (seen) {
        placesX[count] = px;
        placesY[count++] = py;
      }
    }
    svg.curve(Arrays.copyOf(placesX, count), Arrays.copyOf(placesY, count), ink.light(), dashes);
  }

  /** A mark at a point. */
  public void mark(double atX, double atY, Mark mark, PlotInk ink) {
    svg.mark(right(atX), down(atY), mark, ink.light(), true);
  }

  /** A line across at a value of y. */
  public void level(double value) {
    svg.line(LEFT, down(value), WIDTH - RIGHT, down(value), PlotInk.GREY.light(), "2 3");
  }

  /** Says what a curve is. */
  public void nameCurve(String name, PlotInk ink, String dashes) {
    double[] ends = {legendAt, legendAt + SAMPLE};
    svg.curve(ends, new double[] {TOP - 16, TOP - 16}, ink.light(), dashes);
    name(name, SAMPLE);
  }

  /** Says what a mark is. */
  public void nameMark(String name, Mark mark, PlotInk ink) {
    svg.mark(legendAt + 6, TOP - 16, mark, ink.light(), true);
    name(name, 12);
  }

  private void name(String name, int width) {
    svg.text(legendAt + width + 6, TOP - 12, name, Anchor.START, 0);
    legendAt += width + 6 + 7 * name.length() + 14; // letters of about 7 pixels
  }

  /** The picture as SVG. */
  @Override
  public String toString() {
    return svg.toString();
  }
}
