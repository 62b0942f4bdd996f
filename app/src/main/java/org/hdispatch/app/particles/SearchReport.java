package org.hdispatch.app.particles;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.text.Columns;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.app.watch.CollectorReport;
import org.hdispatch.gc.GcWatch;
import org.hdispatch.sph.SphTimes;
import org.hdispatch.sph.cases.SphFigures;

/** A study of searches for programs (the keys stay as they are) and for people. */
final class SearchReport {
  private SearchReport() {}

  /** One row a run. */
  static List<FlatRow> rows(SearchResult result) {
    return result.points().stream().map(point -> row(result, point)).toList();
  }

  private static FlatRow row(SearchResult result, SearchResult.Point point) {
    SphFigures figures = point.figures();
    List<SphFigures> rounds = point.rounds();
    SphTimes seconds = figures.seconds();
    FlatRow row =
        new FlatRow()
            .put("search", Choices.word(point.mode()))
            .put("threads", point.threads())
            .put("cell_edge", point.edge())
            .put("particle_steps_per_s", figures.particleStepsPerSecond())
            .put("neighbours_mean", figures.neighboursMean())
            .put("speed_up", result.speedUp(point))
            .put("efficiency", result.efficiency(point))
            .put("bytes_per_particle", figures.bytesPerParticle())
            .put("bytes_per_step", CollectorReport.bytes(figures.stats()))
            .put("search_share", seconds.search() / figures.wallSeconds())
            .put("density_share", seconds.density() / figures.wallSeconds())
            .put("force_share", seconds.force() / figures.wallSeconds())
            .put("rebuilds", figures.rebuilds())
            .put("particle_steps_per_s_least", rounds.get(0).particleStepsPerSecond())
            .put(
                "particle_steps_per_s_most", rounds.get(rounds.size() - 1).particleStepsPerSecond())
            .put("rounds", rounds.size())
            .put("wanted_cell_edge", point.wantedEdge())
            .put("cells", figures.cells())
            .put("particles", figures.particles())
            .put("fluid_particles", figures.fluidParticles())
            .put("steps", figures.stats().steps())
            .put("warm_up_steps", figures.warmUpSteps())
            .put("form", Choices.word(result.form()))
            .put("case", result.name())
            .put("collector", GcWatch.collector());
    return Host.describe(row);
  }

  /** The runs as a table, and what follows from them. */
  static String text(SearchResult result) {
    Columns columns =
        new Columns()
            .line(
                "search",
                "threads",
                "cells",
                "MPUPS",
                "least",
                "most",
                "neighbours",
                "speed-up",
                "efficiency",
                "bytes",
                "bytes/step",
                "search",
                "density",
                "force",
                "rebuilds");
    result.points().forEach(point -> columns.line(cells(result, point)));
    SphFigures any = result.points().get(0).figures();
    Table table =
        new Table()
            .line("stepped", result.name())
            .line(
                "particles",
                any.particles()
                    + ", of which "
                    + any.fluidParticles()
                    + " fluid; "
                    + Choices.word(result.form())
                    + " sums, Java "
                    + Version.ofJava()
                    + ", "
                    + GcWatch.collector())
            .line(
                "MPUPS",
                "10^6 steps of fluid particles a second, median of "
                    + result.points().get(0).rounds().size()
                    + " rounds of "
                    + any.stats().steps()
                    + " steps, after "
                    + any.warmUpSteps()
                    + " of warm-up")
            .line("cells", "edge, in distances of particles")
            .line("speed-up", "over one thread, same search and cells; efficiency: per thread")
            .line("bytes", "held a particle; bytes/step: allocated by the worst worker")
            .line("search, density, force", "shares of the time");
    result
        .modes()
        .forEach(
            mode ->
                result
                    .best(mode, result.mostThreads())
                    .ifPresent(
                        best ->
                            table.line(
                                "fastest " + Choices.word(mode),
                                fixed(1e-6 * best.speed(), 3)
                                    + " MPUPS with cells of "
                                    + fixed(best.edge(), 2)
                                    + ", "
                                    + Numbers.threads(best.threads()))));
    return columns + System.lineSeparator() + table;
  }

  private static String[] cells(SearchResult result, SearchResult.Point point) {
    SphFigures figures = point.figures();
    List<SphFigures> rounds = point.rounds();
    Long bytes = CollectorReport.bytes(figures.stats());
    double wall = figures.wallSeconds();
    return new String[] {
      Choices.word(point.mode()),
      Integer.toString(point.threads()),
      fixed(point.edge(), 2),
      fixed(1e-6 * point.speed(), 3),
      fixed(1e-6 * rounds.get(0).particleStepsPerSecond(), 3),
      fixed(1e-6 * rounds.get(rounds.size() - 1).particleStepsPerSecond(), 3),
      fixed(figures.neighboursMean(), 1),
      result.speedUp(point).isPresent() ? fixed(result.speedUp(point).getAsDouble(), 2) : "-",
      percent(result.efficiency(point)),
      fixed(figures.bytesPerParticle(), 0),
      bytes == null ? "unknown" : bytes.toString(),
      percent(OptionalDouble.of(figures.seconds().search() / wall)),
      percent(OptionalDouble.of(figures.seconds().density() / wall)),
      percent(OptionalDouble.of(figures.seconds().force() / wall)),
      Long.toString(figures.rebuilds())
    };
  }

  private static String fixed(double value, int digits) {
    return String.format(Locale.ROOT, "%." + digits + "f", value);
  }

  private static String percent(OptionalDouble share) {
    return share.isPresent() ? fixed(100 * share.getAsDouble(), 1) + " %" : "-";
  }
}
