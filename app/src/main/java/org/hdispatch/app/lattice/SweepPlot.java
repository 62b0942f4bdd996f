package org.hdispatch.app.lattice;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.hdispatch.app.draw.ColourMap;
import org.hdispatch.app.draw.Drawing.Anchor;
import org.hdispatch.app.draw.Drawing.Mark;
import org.hdispatch.app.draw.LinearAxis;
import org.hdispatch.app.draw.SvgWriter;
import org.hdispatch.app.text.Numbers;

/**
 * A sweep as a picture after figure 4 of Leonardi et al. 2011: above, the speed of each bundle;
 * below, the efficiency, if there is more than one number of threads. A colour for each of those,
 * from dark to bright, a mark for each size (four at most differ); cubes are joined, other shapes
 * and the control (an outline) stand for themselves.
 */
final class SweepPlot {
  /** The brightest of viridis that is used: yellow is hard to see on white. */
  private static final double BRIGHTEST = 0.7;

  private static final String[] DASHES = {"", "7 4", "2 3", "8 3 2 3"};
  private static final String GREY = "#888888";
  private static final String PALE = "#dddddd";

  private static final int LEFT = 70;
  private static final int RIGHT = 190;
  private static final int PANEL_WIDTH = 620;
  private static final int PANEL_HEIGHT = 260;
  private static final int TOP = 50;
  private static final int BETWEEN = 40;
  private static final int BOTTOM = 90;
  private static final int LEGEND_LINE = 20;
  private static final int TICKS = 5;

  private final SweepResult result;
  private final List<String> labels;
  private final boolean hasEfficiency;
  private final int bottom; // of the lowest panel
  private final SvgWriter svg;

  private SweepPlot(SweepResult result) {
    this.result = result;
    labels = result.labels();
    hasEfficiency = result.threads().size() > 1;
    bottom = TOP + PANEL_HEIGHT + (hasEfficiency ? BETWEEN + PANEL_HEIGHT : 0);
    int lines = result.threads().size() + result.sides().size() + 1;
    svg =
        new SvgWriter(
            LEFT + PANEL_WIDTH + RIGHT,
            Math.max(bottom, TOP + (lines + 1) * LEGEND_LINE) + BOTTOM,
            "Speed and efficiency of a square duct by bundle");
  }

  /** The picture as SVG. */
  static String of(SweepResult result) {
    return new SweepPlot(result).draw();
  }

  private String draw() {
    svg.text(LEFT, TOP - 20, "Square duct, " + result.settings(), Anchor.START, 0);
    new Panel(TOP, "speed, MLUPS", p -> OptionalDouble.of(p.mlups())).draw();
    if (hasEfficiency) {
      new Panel(
              TOP + PANEL_HEIGHT + BETWEEN,
              "efficiency, % of the threads",
              p -> p.threads() == 1 ? OptionalDouble.empty() : percent(result.efficiency(p)))
          .draw();
    }
    bundleLabels();
    legend();
    return svg.toString();
  }

  private static OptionalDouble percent(OptionalDouble share) {
    return share.isPresent() ? OptionalDouble.of(100 * share.getAsDouble()) : share;
  }

  private double x(String label) {
    return LEFT + (labels.indexOf(label) + 0.5) * PANEL_WIDTH / labels.size();
  }

  private String colour(int threads) {
    List<Integer> all = result.threads();
    double place = (double) all.indexOf(threads) / Math.max(1, all.size() - 1);
    return String.format("#%06x", ColourMap.viridis(BRIGHTEST * place));
  }

  private String dashes(int side) {
    return DASHES[result.sides().indexOf(side) % DASHES.length];
  }

  private Mark mark(int side) {
    return Mark.values()[result.sides().indexOf(side) % Mark.values().length];
  }

  private void bundleLabels() {
    for (String label : labels) {
      svg.text(x(label) + 4, bottom + 18, label, Anchor.END, -40);
    }
    svg.text(
        LEFT + PANEL_WIDTH,
        bottom + BOTTOM - 8,
        "bundle, nodes (of a cube, or x,y,z)",
        Anchor.END,
        0);
  }

  private void legend() {
    int x = LEFT + PANEL_WIDTH + 20;
    int y = TOP + 10;
    for (int threads : result.threads()) {
      svg.rectangle(x, y - 4, 30, 8, colour(threads));
      svg.text(x + 40, y + 4, Numbers.threads(threads), Anchor.START, 0);
      y += LEGEND_LINE;
    }
    for (int side : result.sides()) {
      svg.line(x, y, x + 30, y, GREY, dashes(side));
      svg.mark(x + 15, y, mark(side), GREY, true);
      svg.text(x + 40, y + 4, side + "\u00b3 nodes", Anchor.START, 0);
      y += LEGEND_LINE;
    }
    svg.mark(x + 15, y, Mark.CIRCLE, GREY, false);
    svg.text(x + 40, y + 4, "one block a thread", Anchor.START, 0);
  }

  /** One of the two coordinate systems. */
  private final class Panel {
    private final int top;
    private final String title;
    private final Function<SweepResult.Point, OptionalDouble> value;
    private final double tick;
    private final double highest;

    Panel(int top, String title, Function<SweepResult.Point, OptionalDouble> value) {
      this.top = top;
      this.title = title;
      this.value = value;
      double most =
          result.points().stream().map(value).mapToDouble(v -> v.orElse(0)).max().orElse(0);
      tick = LinearAxis.tickDistance(most > 0 ? most : 1);
      highest = tick * Math.ceil(most > 0 ? most / tick : 1);
    }

    private double y(double of) {
      return top + PANEL_HEIGHT * (1 - of / highest);
    }

    void draw() {
      axes();
      series();
    }

    private void axes() {
      for (int n = 0; n * tick <= highest * (1 + 1e-9); n++) {
        double y = y(n * tick);
        svg.line(LEFT, y, LEFT + PANEL_WIDTH, y, n == 0 ? GREY : PALE, "");
        svg.text(LEFT - 8, y + 4, Numbers.significant(n * tick, 3), Anchor.END, 0);
      }
      svg.line(LEFT, top, LEFT, top + PANEL_HEIGHT, GREY, "");
      svg.text(LEFT - 48, top + PANEL_HEIGHT / 2.0, title, Anchor.MIDDLE, -90);
      for (String label : labels) {
        svg.line(x(label), y(0), x(label), y(0) + 5, GREY, "");
      }
    }

    private void series() {
      for (int side : result.sides()) {
        for (int threads : result.threads()) {
          series(side, threads);
        }
      }
    }

    private void series(int side, int threads) {
      SweepResult.Point last = null; // the cube before
      for (String label : labels) {
        SweepResult.Point point = result.at(side, label, threads).orElse(null);
        if (point != null && value.apply(point).isPresent()) {
          double y = y(value.apply(point).getAsDouble());
          boolean cube = !point.what().isControl() && !label.contains(",");
          if (cube && last != null) {
            double from = y(value.apply(last).getAsDouble());
            svg.line(x(last.label()), from, x(label), y, colour(threads), dashes(side));
          }
          svg.mark(x(label), y, mark(side), colour(threads), !point.what().isControl());
          last = cube ? point : last;
        }
      }
    }
  }
}
