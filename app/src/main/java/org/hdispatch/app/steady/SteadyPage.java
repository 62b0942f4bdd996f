package org.hdispatch.app.steady;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.draw.Drawing.Mark;
import org.hdispatch.app.draw.LogPlot;
import org.hdispatch.app.draw.LogPlot.Scale;
import org.hdispatch.app.draw.PlotInk;
import org.hdispatch.app.draw.StudyPage;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.flow.Approach;

/** A study of steady states as a page. */
final class SteadyPage {
  private static final String PLAIN_DASHES = "7 4";

  /** Errors that are drawn, at least and at most. */
  private static final double LEAST_ERROR = 1e-5;

  private static final double MOST_ERROR = 1;

  private final SteadyResult result;
  private final List<SteadyComparison> rocks;
  private final Scale errors;

  SteadyPage(SteadyResult result) {
    this.result = result;
    rocks = result.rocks();
    double most =
        points()
            .mapToDouble(each -> each.course().error(each.point()))
            .filter(Double::isFinite)
            .max()
            .orElse(MOST_ERROR);
    errors = new Scale("error of k", LEAST_ERROR, decadeAbove(most), Numbers::plainPercent);
  }

  private static double decadeAbove(double value) {
    double decade = MOST_ERROR;
    while (decade < value) {
      decade *= 10;
    }
    return decade;
  }

  /** A measurement and whose it is. */
  private record Measured(SteadyCourse course, SteadyCourse.Point point) {}

  private Stream<Measured> points() {
    return rocks.stream()
        .flatMap(rock -> rock.courses().stream())
        .flatMap(course -> course.points().stream().map(point -> new Measured(course, point)));
  }

  private static PlotInk ink(Approach approach) {
    return approach == Approach.CORRECTED ? PlotInk.FIRST : PlotInk.SECOND;
  }

  private static String dashes(Approach approach) {
    return approach == Approach.CORRECTED ? "" : PLAIN_DASHES;
  }

  /**
   * The page.
   *
   * @param command that repeats the study
   * @param files that lie beside the page
   */
  String page(String command, List<String> files) {
    StudyPage page =
        new StudyPage(
            "How k comes to its steady value",
            "Pressure started and corrected (the default) against plain stepping from rest, in "
                + (rocks.size() == 1 ? "one rock" : rocks.size() + " rocks")
                + ", flow along "
                + Choices.word(result.options().axis())
                + ".");
    page.section("Verdict").verdict(new SteadyVerdict(result).sentences());
    overview()
        .ifPresent(
            pictures ->
                page.figure(
                    "Steps and seconds until k stays within 0.1 % of"
                        + " its steady value, by porosity.",
                    pictures));
    page.section("Steps and seconds")
        .table(
            "Until k stays within 1 % and 0.1 % of its steady value. Ratio: plain over corrected.",
            SteadyReport.ARRIVALS.stream().map(SteadyPage::withSquares).toList(),
            SteadyReport.arrivals(result))
        .section("The stop rule")
        .table(
            "Where the program would have stopped at an estimated error of "
                + Numbers.plainPercent(result.options().tolerance())
                + ", what it estimated there, and how far off k really was.",
            SteadyReport.STOPS,
            SteadyReport.stops(result));
    page.section("How the error falls")
        .paragraph(
            "Relative error of k against steps and against seconds; all rocks have the same axes. A"
                + " curve ends "
                + "once the error has stayed below "
                + Numbers.plainPercent(result.close())
                + " and the stop rule was met. Where k crosses its steady value, the curve dips.");
    Scale steps = scale("steps", SteadyCourse.Point::step);
    Scale seconds = scale("seconds", SteadyCourse.Point::seconds);
    for (SteadyComparison each : rocks) {
      page.figure(
          "Porosity "
              + Numbers.plain(each.porosity(), 3)
              + ": "
              + withSquares(SteadyReport.rock(each)),
          List.of(
              curves(each, steps, SteadyCourse.Point::step),
              curves(each, seconds, SteadyCourse.Point::seconds)));
    }
    page.section("How it was measured").points(method());
    page.section("Do it again").command(command).files(files);
    return page.toString();
  }

  private static String withSquares(String ascii) {
    return ascii.replace("voxel2", "voxel\u00b2");
  }

  private Scale scale(String title, ToDoubleFunction<SteadyCourse.Point> what) {
    return scale(title, points().mapToDouble(each -> what.applyAsDouble(each.point())));
  }

  private static Scale scale(String title, DoubleStream values) {
    double[] sorted = values.sorted().toArray();
    return Scale.around(
        title, sorted[0], sorted[sorted.length - 1], value -> Numbers.plain(value, 6));
  }

  private String curves(
      SteadyComparison each, Scale along, ToDoubleFunction<SteadyCourse.Point> what) {
    LogPlot plot =
        new LogPlot(
            "Error of k against "
                + along.title()
                + ", porosity "
                + Numbers.plain(each.porosity(), 3),
            along,
            errors);
    for (double share : SteadyResult.SHARES) {
      plot.level(share);
    }
    for (SteadyCourse course : each.courses()) {
      plot.curve(
          course.points().stream().mapToDouble(what).toArray(),
          course.points().stream().mapToDouble(course::error).toArray(),
          ink(course.approach()),
          dashes(course.approach()));
    }
    for (SteadyCourse course : each.courses()) {
      course
          .stop()
          .ifPresent(
              stop ->
                  plot.mark(
                      what.applyAsDouble(stop),
                      course.error(stop),
                      Mark.CIRCLE,
                      ink(course.approach())));
      plot.nameCurve(
          Choices.word(course.approach()), ink(course.approach()), dashes(course.approach()));
    }
    plot.nameMark("stop rule", Mark.CIRCLE, PlotInk.GREY);
    return plot.toString();
  }

  /** Steps and seconds by porosity, if there is more than one and both ways arrive somewhere. */
  Optional<List<String>> overview() {
    SteadyVerdict verdict = new SteadyVerdict(result);
    boolean drawn =
        rocks.stream().mapToDouble(SteadyComparison::porosity).distinct().count() > 1
            && !verdict.arrivals(Approach.CORRECTED).isEmpty()
            && !verdict.arrivals(Approach.PLAIN).isEmpty();
    return drawn
        ? Optional.of(
            List.of(
                overview("steps", SteadyCourse.Point::step),
                overview("seconds", SteadyCourse.Point::seconds)))
        : Optional.empty();
  }

  private String overview(String title, ToDoubleFunction<SteadyCourse.Point> what) {
    List<SteadyComparison> byPorosity =
        rocks.stream().sorted(Comparator.comparingDouble(SteadyComparison::porosity)).toList();
    List<SteadyCourse.Point> all = new ArrayList<>();
    SteadyVerdict verdict = new SteadyVerdict(result);
    for (Approach approach : Approach.values()) {
      all.addAll(verdict.arrivals(approach));
    }
    LogPlot plot =
        new LogPlot(
            title + " until k stays within 0.1 % of its steady value",
            scale("porosity", rocks.stream().mapToDouble(SteadyComparison::porosity)),
            scale(title, all.stream().mapToDouble(what)));
    for (Approach approach : Approach.values()) {
      List<double[]> arrived = new ArrayList<>();
      for (SteadyComparison each : byPorosity) {
        SteadyCourse course = approach == Approach.CORRECTED ? each.corrected() : each.plain();
        course
            .within(SteadyVerdict.SHARE)
            .ifPresent(
                point -> arrived.add(new double[] {each.porosity(), what.applyAsDouble(point)}));
      }
      plot.curve(
          arrived.stream().mapToDouble(point -> point[0]).toArray(),
          arrived.stream().mapToDouble(point -> point[1]).toArray(),
          ink(approach),
          dashes(approach));
      arrived.forEach(point -> plot.mark(point[0], point[1], Mark.CIRCLE, ink(approach)));
      plot.nameCurve(Choices.word(approach), ink(approach), dashes(approach));
    }
    return plot.toString();
  }

  private List<String> method() {
    List<String> points = new ArrayList<>();
    if (rocks.get(0).rock().origin().containsKey("spheres_seed")) {
      points.add(
          "Rocks: overlapping random spheres of radius "
              + rocks.get(0).rock().origin().get("spheres_radius_voxel")
              + " voxels, seed "
              + rocks.get(0).rock().origin().get("spheres_seed")
              + ", "
              + rocks.get(0).rock().space().nx()
              + "\u00b3 voxels; a tighter rock has the spheres of a more open one, and more.");
    } else {
      rocks.stream()
          .flatMap(each -> each.rock().citation().stream())
          .distinct()
          .forEach(points::add);
    }
    points.add(
        "Flow: lattice Boltzmann, D3Q19, two relaxation times, bounce-back at the walls, sides"
            + " closed, a slab of fluid at each end. Each approach has the tau that the program"
            + " chooses for it; k does not depend on it.");
    points.add(
        "Steady k: the corrected approach, to an estimated error of "
            + Numbers.plainPercent(result.referenceTolerance())
            + ". That run does the same steps as the one that is timed after it, and warms the JVM"
            + " up.");
    points.add(
        "Steps: k is looked at when the program does so to decide whether to stop, every "
            + intervals(Approach.CORRECTED)
            + " steps when corrected and every "
            + intervals(Approach.PLAIN)
            + " when plain. Numbers of steps are multiples of that.");
    points.add(
        "Seconds: wall time of the steps and of all that has to do with pressure, its set-up"
            + " included. Set-up of the lattice, the same for both, and reading k are left out.");
    points.add(
        "Stay within: from there to the end of the curve. A run was given up after "
            + result.options().maxSteps()
            + " steps.");
    points.add(
        "Machine: "
            + Numbers.threads(result.threads())
            + ", "
            + Runtime.getRuntime().availableProcessors()
            + " processors ("
            + System.getProperty("os.arch")
            + "), Java "
            + Version.ofJava()
            + ", H-Dispatch "
            + Version.ofProject()
            + ".");
    return points;
  }

  private String intervals(Approach approach) {
    long[] sorted =
        rocks.stream()
            .flatMap(each -> each.courses().stream())
            .filter(course -> course.approach() == approach)
            .mapToLong(SteadyCourse::interval)
            .sorted()
            .toArray();
    return Numbers.span(sorted[0], sorted[sorted.length - 1], 9);
  }
}
