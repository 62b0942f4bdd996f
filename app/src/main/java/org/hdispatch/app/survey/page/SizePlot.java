package org.hdispatch.app.survey.page;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleFunction;
import org.hdispatch.app.draw.Drawing.Mark;
import org.hdispatch.app.draw.LinearAxis;
import org.hdispatch.app.draw.LogPlot;
import org.hdispatch.app.draw.LogPlot.Scale;
import org.hdispatch.app.draw.PlotAxis;
import org.hdispatch.app.draw.PlotInk;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.survey.BlockScale;
import org.hdispatch.porous.survey.PorosityScale;
import org.hdispatch.porous.survey.Spread;

/** Mean and spread of porosity and permeability against the size of the blocks. */
final class SizePlot {
  private static final List<PlotInk> INKS = List.of(PlotInk.FIRST, PlotInk.SECOND, PlotInk.THIRD);
  private static final double ASIDE = 1.035; // so that bars do not hide each other

  private final SurveyStudy report;

  SizePlot(SurveyStudy report) {
    this.report = report;
  }

  /** A size of blocks and what they have. */
  private record Point(double edge, Spread spread) {
    double least() {
      return spread.arithmetic() - deviation();
    }

    double most() {
      return spread.arithmetic() + deviation();
    }

    /** Standard deviation; 0 of a single block, which has none. */
    double deviation() {
      return spread.count() > 1 ? spread.deviation() : 0;
    }
  }

  /** A curve of a plot. */
  private record Curve(String name, PlotInk ink, List<Point> points) {}

  /** Edges of blocks, logarithmic, with a number at each that there is. */
  private record EdgeAxis(Scale scale, List<Double> ticks) implements PlotAxis {
    static EdgeAxis of(double[] edges) {
      return new EdgeAxis(
          Scale.close(
              "edge of a block, voxels",
              edges[0],
              edges[edges.length - 1],
              value -> Numbers.plain(value, 3)),
          Arrays.stream(edges).boxed().toList());
    }

    @Override
    public String title() {
      return scale.title();
    }

    @Override
    public double least() {
      return scale.least();
    }

    @Override
    public double most() {
      return scale.most();
    }

    @Override
    public DoubleFunction<String> label() {
      return scale.label();
    }

    @Override
    public double place(double value) {
      return scale.place(value);
    }
  }

  /** The pictures, as SVG: those that have at least two sizes to show. */
  List<String> pictures() {
    List<String> pictures = new ArrayList<>();
    for (Map.Entry<String, List<PorosityScale>> each : report.porosities().entrySet()) {
      add(
          pictures,
          "Porosity of " + each.getKey() + ", cubes of the whole image",
          "porosity",
          List.of(
              new Curve(
                  "",
                  PlotInk.FIRST,
                  each.getValue().stream()
                      .map(scale -> new Point(scale.edge(), scale.porosity()))
                      .toList())));
    }
    for (SurveyStudy.Rev rev : report.revs()) {
      List<BlockScale> scales = rev.scales();
      String of = rev.first().name().replace(", " + rev.first().blockWords(), "");
      if (!report.porosities().containsKey(rev.first().rock())) {
        add(
            pictures,
            "Porosity of the blocks of " + of,
            "porosity",
            List.of(
                new Curve(
                    "",
                    PlotInk.FIRST,
                    scales.stream()
                        .filter(scale -> scale.porosity().count() > 0)
                        .map(scale -> new Point(scale.edge(), scale.porosity()))
                        .toList())));
      }
      List<Curve> curves = new ArrayList<>();
      for (Axis axis : Axis.values()) {
        List<Point> points =
            scales.stream()
                .filter(scale -> scale.permeability().containsKey(axis))
                .map(scale -> new Point(scale.edge(), scale.permeability().get(axis)))
                .toList();
        if (!points.isEmpty()) {
          curves.add(
              new Curve(
                  "along " + axis.name().toLowerCase(Locale.ROOT),
                  INKS.get(axis.ordinal()),
                  points));
        }
      }
      add(pictures, "Permeability of the blocks of " + of, "permeability, mD", curves);
    }
    return pictures;
  }

  private static void add(List<String> pictures, String heading, String title, List<Curve> curves) {
    double[] edges =
        curves.stream()
            .flatMap(curve -> curve.points().stream())
            .mapToDouble(Point::edge)
            .distinct()
            .sorted()
            .toArray();
    double most =
        curves.stream()
            .flatMap(curve -> curve.points().stream())
            .mapToDouble(Point::most)
            .max()
            .orElse(0);
    if (edges.length < 2 || !(most > 0)) {
      return;
    }
    LogPlot plot = LogPlot.headed(heading, EdgeAxis.of(edges), new LinearAxis(title, 1.05 * most));
    double aside = Math.pow(ASIDE, (1 - curves.size()) / 2.0);
    for (Curve curve : curves) {
      double[] xs = new double[curve.points().size()];
      double[] ys = new double[xs.length];
      for (int n = 0; n < xs.length; n++) {
        Point point = curve.points().get(n);
        xs[n] = point.edge() * aside;
        ys[n] = point.spread().arithmetic();
        plot.bar(xs[n], point.least(), point.most(), curve.ink());
      }
      plot.curve(xs, ys, curve.ink(), "");
      for (int n = 0; n < xs.length; n++) {
        plot.mark(xs[n], ys[n], Mark.CIRCLE, curve.ink());
      }
      if (!curve.name().isEmpty()) {
        plot.nameMark(curve.name(), Mark.CIRCLE, curve.ink());
      }
      aside *= ASIDE;
    }
    pictures.add(plot.toString());
  }
}
