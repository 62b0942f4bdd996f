package org.hdispatch.app.draw;

import java.util.Arrays;
import java.util.TreeMap;
import org.hdispatch.app.draw.Drawing.Anchor;

/**
 * Lanes one above the other on one axis to the right, each with the same axis upwards; small enough
 * for a phone. A lane may have a thin strip below it, on the same two axes.
 */
public final class LanePlot {
  private static final int WIDTH = 420;
  private static final int LEFT = 76;
  private static final int RIGHT = 18;
  private static final int HEADING = 26;
  private static final int NAME = 24; // above each lane
  private static final int STRIP = 17;
  private static final int GAP = 10;
  private static final int BOTTOM = 42;
  private static final int LEGEND = 226;

  /** Distance from one number to the next on the axis upwards, at least. */
  private static final int LABELS_APART = 17;

  /** Height of the lowest number: below it is the strip's. */
  private static final int LOWEST = 5;

  /** Upright lines closer than this are drawn as one. */
  private static final double APART = 0.5;

  /** Height of the least of them. */
  private static final double SEEN = 2;

  private final PlotAxis x;
  private final PlotAxis y;
  private final int height;
  private final boolean strips;
  private final SvgWriter svg;
  private int top;
  private double legendAt = LEGEND;

  /** Whether lanes have strips below them. */
  public enum Strips {
    WITH,
    WITHOUT
  }

  /**
   * A plot with no lanes yet.
   *
   * @param heading what is shown
   * @param lanes how many there will be
   * @param height of a lane, pixels
   * @param x axis to the right
   * @param y axis upwards, of each lane
   */
  public LanePlot(String heading, int lanes, int height, Strips strips, PlotAxis x, PlotAxis y) {
    this.x = x;
    this.y = y;
    this.height = height;
    this.strips = strips == Strips.WITH;
    svg = new SvgWriter(WIDTH, HEADING - GAP + lanes * pitch() + BOTTOM, heading);
    svg.text(0, 14, heading, Anchor.START, 0);
    double bottom = HEADING - GAP + lanes * pitch();
    svg.line(LEFT, bottom + 5, WIDTH - RIGHT, bottom + 5, PlotInk.GREY.light(), "");
    for (double tick : x.ticks()) {
      svg.line(right(tick), bottom + 5, right(tick), bottom + 9, PlotInk.GREY.light(), "");
      svg.text(right(tick), bottom + 22, x.label().apply(tick), Anchor.MIDDLE, 0);
    }
    svg.text((LEFT + WIDTH - RIGHT) / 2.0, bottom + 38, x.title(), Anchor.MIDDLE, 0);
    top = HEADING - GAP - pitch();
  }

  private int pitch() {
    return GAP + NAME + height + (strips ? STRIP : 0);
  }

  private double right(double value) {
    return LEFT + (WIDTH - LEFT - RIGHT) * x.place(value);
  }

  /** Lower edge of the lane. */
  private double floor() {
    return top + GAP + NAME + height;
  }

  /** Says what a colour is. */
  public void name(String name, PlotInk ink) {
    legendAt = svg.name(legendAt, 14, name, ink.light());
  }

  /** Goes on to the next lane. */
  public void lane(String name, String note) {
    top += pitch();
    svg.text(0, top + GAP + NAME - 9, name, Anchor.START, 0);
    svg.text(WIDTH - RIGHT, top + GAP + NAME - 9, note, Anchor.END, 0);
    for (double tick : x.ticks()) {
      svg.line(right(tick), floor() - height, right(tick), floor(), PlotInk.PALE.light(), "");
    }
    svg.line(LEFT, floor(), WIDTH - RIGHT, floor(), PlotInk.PALE.light(), "");
    double last = Double.POSITIVE_INFINITY;
    for (double tick : y.ticks()) {
      double at = floor() - height * y.place(tick);
      if (last - at >= LABELS_APART && floor() - at >= LOWEST) {
        svg.line(LEFT - 4, at, WIDTH - RIGHT, at, PlotInk.PALE.light(), "");
        svg.text(LEFT - 7, at + 4, y.label().apply(tick), Anchor.END, 0);
        last = at;
      }
    }
  }

  /**
   * Upright lines in the lane, of these heights; where several fall together, the highest.
   *
   * @param until where the lane ends
   */
  public void ticks(double[] xs, double[] ys, double until, PlotInk ink) {
    svg.line(LEFT, floor(), right(until), floor(), ink.light(), "");
    upright(xs, ys, floor(), height, ink);
  }

  /** The same in the strip below the lane. */
  public void strip(String name, double[] xs, double[] ys, double until, PlotInk ink) {
    double base = floor() + STRIP;
    svg.text(LEFT - 7, base + 3, name, Anchor.END, 0);
    double[] ends = {LEFT, right(until)};
    svg.curve(ends, new double[] {base, base}, ink.light(), "");
    upright(xs, ys, base, STRIP - 2, ink);
  }

  private void upright(double[] xs, double[] ys, double base, double room, PlotInk ink) {
    TreeMap<Double, Double> highest = new TreeMap<>();
    for (int n = 0; n < xs.length; n++) {
      double place = APART * Math.round(right(xs[n]) / APART);
      highest.merge(place, base - Math.max(SEEN, room * y.place(ys[n])), Math::min);
    }
    if (!highest.isEmpty()) {
      svg.ticks(
          highest.keySet().stream().mapToDouble(Double::doubleValue).toArray(),
          highest.values().stream().mapToDouble(Double::doubleValue).toArray(),
          base,
          ink.light());
    }
  }

  /**
   * The outline of a histogram in the lane.
   *
   * @param edges between classes, ascending; shape: [classes + 1]
   * @param counts in the classes; shape: [classes]
   */
  public void outline(double[] edges, double[] counts, PlotInk ink) {
    double[] px = new double[2 * counts.length + 2];
    double[] py = new double[px.length];
    Arrays.fill(py, floor());
    for (int n = 0; n < counts.length; n++) {
      px[2 * n + 1] = right(edges[n]);
      px[2 * n + 2] = right(edges[n + 1]);
      py[2 * n + 1] = floor() - height * y.place(counts[n]);
      py[2 * n + 2] = py[2 * n + 1];
    }
    px[0] = right(edges[0]);
    px[px.length - 1] = right(edges[counts.length]);
    svg.curve(px, py, ink.light(), "");
  }

  /** Says in the lane that there is nothing to be seen. */
  public void nothing(String why) {
    svg.text(LEFT + 8, floor() - height / 2.0 + 4, why, Anchor.START, 0);
  }

  /** The picture as SVG. */
  @Override
  public String toString() {
    return svg.toString();
  }
}
