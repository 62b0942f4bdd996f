package org.hdispatch.app.survey.page;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import org.hdispatch.app.draw.Drawing;
import org.hdispatch.app.draw.Drawing.Anchor;
import org.hdispatch.app.draw.Drawing.Mark;
import org.hdispatch.app.draw.LogPlot;
import org.hdispatch.app.draw.LogPlot.Scale;
import org.hdispatch.app.draw.PixelDrawing;
import org.hdispatch.app.draw.PlotInk;
import org.hdispatch.app.draw.SvgWriter;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.survey.GivenPoint;
import org.hdispatch.porous.survey.ReferenceBand;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;

/**
 * Permeability against porosity, both logarithmic: a colour for each direction of the flow, a mark
 * for each survey, reference bands and a Kozeny-Carman curve for each rock.
 */
public final class CrossPlot {
  private static final String TITLE = "Permeability against porosity";
  private static final int PLOT = 400; // height without the legend
  private static final int LINE = 19; // of the legend
  private static final int SAMPLE = 26; // of a line or a mark in it
  private static final int LETTERS = 56; // in a line of it
  private static final int CURVE = 120; // points of a curve
  private static final double SMALL = 0.62; // marks, times the usual ones
  private static final double SMALLEST = 0.42;
  private static final double USUAL = 0.75;
  private static final int MANY = 40; // points, above which marks are small
  private static final int MOST = 120; // and above which they are smallest
  private static final String FIT_DASHES = "";
  private static final List<String> MORE_FIT_DASHES = List.of(FIT_DASHES, "12 3", "9 3 2 3");

  private static final List<Mark> MARKS =
      List.of(Mark.CIRCLE, Mark.SQUARE, Mark.TRIANGLE, Mark.DIAMOND);

  private final SurveyStudy report;
  private final Scale x;
  private final Scale y;

  /**
   * A point of a curve of a band.
   *
   * @param band the band
   * @param curve its curve
   * @param porosity where
   */
  record BandPoint(ReferenceBand band, ReferenceBand.Curve curve, double porosity) {}

  /**
   * A figure.
   *
   * @param report what is drawn; at least a point
   */
  public CrossPlot(SurveyStudy report) {
    this.report = report;
    x =
        scale(
            "porosity",
            DoubleStream.concat(
                rows().stream().mapToDouble(Series::porosity),
                given().stream().mapToDouble(GivenPoint::porosity)));
    y =
        scale(
            "permeability, mD",
            DoubleStream.concat(
                rows().stream().mapToDouble(Series::permeability),
                given().stream().mapToDouble(GivenPoint::permeability)));
  }

  private static Scale scale(String title, DoubleStream values) {
    double[] sorted = values.sorted().toArray();
    return Scale.close(
        title,
        sorted.length == 0 ? 1 : sorted[0],
        sorted.length == 0 ? 1 : sorted[sorted.length - 1],
        value -> Numbers.plain(value, 3));
  }

  private List<SurveyRow> rows() {
    return report.series().stream().flatMap(each -> each.drawn().stream()).toList();
  }

  /** Given points that have logarithms. */
  private List<GivenPoint> given() {
    return report.points().stream().filter(CrossPlot::hasLogarithms).toList();
  }

  private static boolean hasLogarithms(GivenPoint point) {
    return point.porosity() > 0 && point.permeability() > 0;
  }

  /** Whether there is anything to draw. */
  public static boolean hasPoints(SurveyStudy report) {
    return report.series().stream().anyMatch(each -> !each.drawn().isEmpty())
        || report.points().stream().anyMatch(each -> each.porosity() * each.permeability() > 0);
  }

  /** The figure as SVG. */
  public String svg() {
    SvgWriter svg = new SvgWriter(LogPlot.WIDTH, height(), TITLE);
    draw(svg);
    return svg.toString();
  }

  /** The figure as pixels. */
  public PixelDrawing pixels() {
    PixelDrawing pixels = new PixelDrawing(LogPlot.WIDTH, height());
    draw(pixels);
    return pixels;
  }

  private static PlotInk ink(Axis axis) {
    return switch (axis) {
      case X -> PlotInk.FIRST;
      case Y -> PlotInk.SECOND;
      case Z -> PlotInk.THIRD;
    };
  }

  private static PlotInk ink(SurveyRow row) {
    return row.status() == SurveyStatus.DONE ? ink(row.job().axis()) : PlotInk.GREY;
  }

  private static Mark mark(int number) {
    return MARKS.get(number % MARKS.size());
  }

  /** The first four surveys have full marks, the next four open ones, and so on. */
  private static boolean isFull(int number) {
    return number / MARKS.size() % 2 == 0;
  }

  private static Mark givenMark(int number) {
    return number % 2 == 0 ? Mark.CROSS : Mark.PLUS;
  }

  /** The more points, the smaller their marks, times the usual ones. */
  private static double markSize(int points) {
    return points > MOST ? SMALLEST : points > MANY ? SMALL : USUAL;
  }

  /** Points that have a mark in common. */
  private record Group(String name, Mark mark, boolean full, List<Point> points) {
    double size() {
      return markSize(points.size());
    }

    void draw(LogPlot plot) {
      points.forEach(
          each -> plot.mark(each.porosity(), each.permeability(), mark, each.ink(), full, size()));
    }
  }

  /** A point and its colour. */
  private record Point(double porosity, double permeability, PlotInk ink) {}

  /** All groups with points, in the order of the legend. */
  private List<Group> groups() {
    List<Group> groups = new ArrayList<>();
    for (Series each : report.series()) {
      int n = groups.size();
      List<Point> points =
          each.drawn().stream()
              .map(row -> new Point(Series.porosity(row), Series.permeability(row), ink(row)))
              .toList();
      if (!points.isEmpty()) {
        groups.add(new Group(each.name(), mark(n), isFull(n), points));
      }
    }
    int label = 0;
    for (Map.Entry<String, List<GivenPoint>> each : report.pointsByLabel().entrySet()) {
      List<Point> points =
          each.getValue().stream()
              .filter(CrossPlot::hasLogarithms)
              .map(
                  point ->
                      new Point(
                          point.porosity(),
                          point.permeability(),
                          point.axis().map(CrossPlot::ink).orElse(PlotInk.DARK)))
              .toList();
      if (!points.isEmpty()) {
        groups.add(new Group(each.getKey(), givenMark(label++), true, points));
      }
    }
    return groups;
  }

  private void draw(Drawing drawing) {
    LogPlot plot = new LogPlot(drawing, PLOT, x, y);
    for (ReferenceBand band : report.bands()) {
      for (ReferenceBand.Curve curve : band.curves()) {
        List<Double> seen = seen(curve::permeability, curve::reaches);
        if (seen.size() > 1) {
          curve(plot, seen, curve::permeability, PlotInk.GREY, dashes(band));
          if (band.curves().size() > 1) {
            double last = seen.get(seen.size() - 1);
            plot.label(last, curve.permeability(last), curve.name());
          }
        }
      }
    }
    List<SurveyStudy.Fit> fits = drawnFits();
    for (int n = 0; n < fits.size(); n++) {
      SurveyStudy.Fit fit = fits.get(n);
      List<Double> seen = seen(fit.curve()::permeability, porosity -> porosity < 1);
      if (seen.size() > 1) {
        curve(plot, seen, fit.curve()::permeability, PlotInk.DARK, fitDashes(n));
      }
    }
    groups().stream() // crowds below, few above
        .sorted(Comparator.comparingInt(each -> -each.points().size()))
        .forEach(each -> each.draw(plot));
    legend(drawing);
  }

  private static String dashes(ReferenceBand band) {
    return switch (band) {
      case LUCIA -> "6 4";
      case FONTAINEBLEAU -> "1.5 3";
    };
  }

  private static String fitDashes(int number) {
    return MORE_FIT_DASHES.get(number % MORE_FIT_DASHES.size());
  }

  private List<SurveyStudy.Fit> drawnFits() {
    return report.fits().stream().filter(SurveyStudy.Fit::drawn).toList();
  }

  /** Porosities across the plot at which a curve lies within it. */
  private List<Double> seen(
      DoubleUnaryOperator permeability, java.util.function.DoublePredicate reaches) {
    List<Double> seen = new ArrayList<>();
    for (int n = 0; n < CURVE; n++) {
      double porosity = x.least() * Math.pow(x.most() / x.least(), n / (CURVE - 1.0));
      double k = permeability.applyAsDouble(porosity);
      if (reaches.test(porosity) && k >= y.least() && k <= y.most()) {
        seen.add(porosity);
      }
    }
    return seen;
  }

  private static void curve(
      LogPlot plot, List<Double> xs, DoubleUnaryOperator permeability, PlotInk ink, String dashes) {
    double[] porosities = xs.stream().mapToDouble(Double::doubleValue).toArray();
    plot.curve(porosities, Arrays.stream(porosities).map(permeability).toArray(), ink, dashes);
  }

  /** The points of the bands that are drawn. */
  List<BandPoint> bandPoints() {
    List<BandPoint> points = new ArrayList<>();
    for (ReferenceBand band : report.bands()) {
      for (ReferenceBand.Curve curve : band.curves()) {
        seen(curve::permeability, curve::reaches)
            .forEach(each -> points.add(new BandPoint(band, curve, each)));
      }
    }
    return points;
  }

  /** A line of the legend, with what stands before it. */
  private record Entry(Sample sample, String text) {}

  /** Draws what stands before a line of the legend. */
  @FunctionalInterface
  private interface Sample {
    void draw(Drawing drawing, double x, double y);
  }

  private List<Entry> entries() {
    List<Entry> entries = new ArrayList<>();
    for (Axis axis : Axis.values()) {
      boolean there =
          rows().stream().anyMatch(row -> row.job().axis() == axis)
              || given().stream().anyMatch(each -> each.axis().equals(Optional.of(axis)));
      if (there) {
        entries.add(
            new Entry(
                (on, left, at) ->
                    on.rectangle(
                        left + 8, at - 5, Drawing.SWATCH, Drawing.SWATCH, ink(axis).light()),
                "flow along " + axis.name().toLowerCase(java.util.Locale.ROOT)));
      }
    }
    if (rows().stream().anyMatch(row -> row.status() != SurveyStatus.DONE)) {
      entries.add(
          new Entry(
              (on, left, at) ->
                  on.rectangle(
                      left + 8, at - 5, Drawing.SWATCH, Drawing.SWATCH, PlotInk.GREY.light()),
              "flow not converged"));
    }
    for (Group each : groups()) {
      entries.add(
          new Entry(
              (on, left, at) ->
                  on.mark(
                      left + 13, at, each.mark(), PlotInk.DARK.light(), each.full(), each.size()),
              each.name()));
    }
    List<SurveyStudy.Fit> fits = drawnFits();
    for (int n = 0; n < fits.size(); n++) {
      String dashes = fitDashes(n);
      entries.add(
          new Entry(
              (on, left, at) -> line(on, left, at, PlotInk.DARK, dashes),
              "Kozeny-Carman, "
                  + fits.get(n).of().rock()
                  + " "
                  + fits.get(n).of().blockWords()
                  + ": "
                  + fits.get(n).words()));
    }
    for (ReferenceBand band : report.bands()) {
      entries.add(
          new Entry(
              (on, left, at) -> line(on, left, at, PlotInk.GREY, dashes(band)), legend(band)));
    }
    return entries;
  }

  private static String legend(ReferenceBand band) {
    return band.title() + ": " + band.source().substring(0, band.source().indexOf(','));
  }

  private static void line(Drawing on, double left, double at, PlotInk ink, String dashes) {
    on.curve(new double[] {left, left + SAMPLE}, new double[] {at, at}, ink.light(), dashes);
  }

  /** A text in lines that are not too long. */
  private static List<String> lines(String text) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : text.split(" ")) {
      if (line.length() > 0 && line.length() + word.length() >= LETTERS) {
        lines.add(line.toString());
        line.setLength(0);
      }
      line.append(line.length() == 0 ? "" : " ").append(word);
    }
    lines.add(line.toString());
    return lines;
  }

  private int height() {
    int lines = entries().stream().mapToInt(each -> lines(each.text()).size()).sum();
    return PLOT + 8 + LINE * lines;
  }

  private void legend(Drawing drawing) {
    double at = PLOT + 12;
    for (Entry each : entries()) {
      each.sample().draw(drawing, 4, at);
      for (String line : lines(each.text())) {
        drawing.text(4 + SAMPLE + 8, at + 4, line, Anchor.START, 0);
        at += LINE;
      }
    }
  }
}
