package org.hdispatch.app.draw;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import org.hdispatch.app.draw.Drawing.Anchor;
import org.hdispatch.app.draw.Drawing.Mark;

/**
 * A plot on two axes, logarithmic ones as a rule, small enough for a phone. What lies outside of
 * the axes is drawn on their edge; so is what a logarithm does not know, zero.
 */
public final class LogPlot {
  private static final int LEFT = 66;
  private static final int RIGHT = 24;
  private static final int TOP = 32;
  private static final int BOTTOM = 46;

  /** Width of all plots, pixels. */
  public static final int WIDTH = 420;

  private static final int HEIGHT = 300;
  private static final int HEADING = 20; // room above the legend
  private static final int SAMPLE = 22; // length of a line in the legend

  /** Pixels by which a curve must go on for another point to be drawn. */
  private static final double VISIBLE = 0.4;

  /** Decades from which on only powers of ten have numbers. */
  private static final double MANY_DECADES = 2.2;

  /** Decades below which many numbers have room. */
  private static final double ONE_DECADE = 0.95;

  /** Decades below which most have. */
  private static final double HALF_DECADE = 0.4;

  private final PlotAxis x;
  private final PlotAxis y;
  private final Drawing drawing;
  private final int top;
  private final int height;
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
    private static final List<String> POWERS = List.of("1");
    private static final List<String> FEW = List.of("1", "2", "5");
    private static final List<String> MOST =
        List.of(
            "1", "1.2", "1.4", "1.6", "1.8", "2", "2.5", "3", "3.5", "4", "5", "6", "7", "8", "9");
    private static final List<String> MANY = List.of("1", "1.5", "2", "3", "4", "5", "6", "8");

    /**
     * From the nearest 1, 2 or 5 times a power of ten below some values to the nearest above.
     *
     * @throws IllegalArgumentException if a value is not positive
     */
    public static Scale around(
        String title, double lowest, double highest, DoubleFunction<String> label) {
      requirePositive(lowest, highest);
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

    /**
     * A little more than from one value to another; on less than a decade, with more numbers.
     *
     * @throws IllegalArgumentException if a value is not positive
     */
    public static Scale close(
        String title, double lowest, double highest, DoubleFunction<String> label) {
      requirePositive(lowest, highest);
      double margin = Math.max(1.1, Math.pow(highest / lowest, 0.06));
      return new Scale(title, lowest / margin, highest * margin, label);
    }

    private static void requirePositive(double lowest, double highest) {
      if (!(lowest > 0 && highest >= lowest && highest < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException(
            "values must be positive: lowest=" + lowest + ", highest=" + highest);
      }
    }

    /** Powers of ten within, and 2 and 5 times such if there would be too few or all are asked. */
    private static List<Double> ticks(double from, double to, boolean all) {
      return ticks(from, to, all ? FEW : POWERS);
    }

    private static List<Double> ticks(double from, double to, List<String> factors) {
      List<Double> ticks = new ArrayList<>();
      for (int power = (int) Math.floor(Math.log10(from)); Math.pow(10, power) <= to; power++) {
        for (String factor : factors) {
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
      double decades = Math.log10(most / least);
      if (decades < ONE_DECADE) {
        return ticks(least, most, decades < HALF_DECADE ? MOST : MANY);
      }
      return ticks(least, most, decades < MANY_DECADES);
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
  public LogPlot(String title, PlotAxis x, PlotAxis y) {
    this(new SvgWriter(WIDTH, HEIGHT, title), TOP, HEIGHT, x, y);
  }

  /**
   * A plot with nothing in it, as wide as others.
   *
   * @param drawing where it is drawn, from the upper left
   * @param height its height, the titles of the axes included, pixels
   * @param x axis to the right
   * @param y axis upwards
   */
  public LogPlot(Drawing drawing, int height, PlotAxis x, PlotAxis y) {
    this(drawing, TOP, height, x, y);
  }

  private LogPlot(Drawing drawing, int top, int height, PlotAxis x, PlotAxis y) {
    this.x = x;
    this.y = y;
    this.drawing = drawing;
    this.top = top;
    this.height = height;
    axes();
  }

  /** A plot with a heading that is seen, above its legend. */
  public static LogPlot headed(String heading, PlotAxis x, PlotAxis y) {
    SvgWriter svg = new SvgWriter(WIDTH, HEIGHT + HEADING, heading);
    svg.text(0, 14, heading, Anchor.START, 0);
    return new LogPlot(svg, TOP + HEADING, HEIGHT + HEADING, x, y);
  }

  private double right(double value) {
    return LEFT + (WIDTH - LEFT - RIGHT) * x.place(value);
  }

  private double down(double value) {
    return height - BOTTOM - (height - top - BOTTOM) * y.place(value);
  }

  private void axes() {
    int bottom = height - BOTTOM;
    int end = WIDTH - RIGHT;
    for (double tick : x.ticks()) {
      drawing.line(right(tick), top, right(tick), bottom + 5, PlotInk.PALE.light(), "");
      drawing.text(right(tick), bottom + 19, x.label().apply(tick), Anchor.MIDDLE, 0);
    }
    for (double tick : y.ticks()) {
      drawing.line(LEFT - 5, down(tick), end, down(tick), PlotInk.PALE.light(), "");
      drawing.text(LEFT - 9, down(tick) + 4, y.label().apply(tick), Anchor.END, 0);
    }
    drawing.line(LEFT, bottom, end, bottom, PlotInk.GREY.light(), "");
    drawing.line(LEFT, top, LEFT, bottom, PlotInk.GREY.light(), "");
    drawing.text((LEFT + end) / 2.0, height - 8, x.title(), Anchor.MIDDLE, 0);
    drawing.text(13, (top + bottom) / 2.0, y.title(), Anchor.MIDDLE, -90);
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
    drawing.curve(
        Arrays.copyOf(placesX, count), Arrays.copyOf(placesY, count), ink.light(), dashes);
  }

  /** A mark at a point. */
  public void mark(double atX, double atY, Mark mark, PlotInk ink) {
    mark(atX, atY, mark, ink, true, 1);
  }

  /** A mark at a point, or its outline if it is not filled; {@code size} times the usual one. */
  public void mark(double atX, double atY, Mark mark, PlotInk ink, boolean filled, double size) {
    drawing.mark(right(atX), down(atY), mark, ink.light(), filled, size);
  }

  /** An upright line at a point, from one value of y to another. */
  public void bar(double atX, double from, double to, PlotInk ink) {
    drawing.line(right(atX), down(from), right(atX), down(to), ink.light(), "");
  }

  /** A text that ends at a point, a little above it. */
  public void label(double atX, double atY, String text) {
    drawing.text(right(atX) - 3, down(atY) - 4, text, Anchor.END, 0);
  }

  /** A line across at a value of y. */
  public void level(double value) {
    drawing.line(LEFT, down(value), WIDTH - RIGHT, down(value), PlotInk.GREY.light(), "2 3");
  }

  /** Says what a curve is. */
  public void nameCurve(String name, PlotInk ink, String dashes) {
    double[] ends = {legendAt, legendAt + SAMPLE};
    drawing.curve(ends, new double[] {top - 16, top - 16}, ink.light(), dashes);
    name(name, SAMPLE);
  }

  /** Says what a mark is. */
  public void nameMark(String name, Mark mark, PlotInk ink) {
    drawing.mark(legendAt + 6, top - 16, mark, ink.light(), true, 1);
    name(name, 12);
  }

  private void name(String name, int width) {
    drawing.text(legendAt + width + 6, top - 12, name, Anchor.START, 0);
    legendAt += width + 6 + 7 * name.length() + 14; // letters of about 7 pixels
  }

  /** The picture as SVG, if it is drawn as such. */
  @Override
  public String toString() {
    return drawing.toString();
  }
}
