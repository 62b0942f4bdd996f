package org.hdispatch.app.particles;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.draw.Drawing.Mark;
import org.hdispatch.app.draw.LogPlot;
import org.hdispatch.app.draw.PlotInk;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.sph.SearchMode;

/** A study of searches as pictures, the first after figure 3 of Leonardi et al. 2011. */
final class SearchPlots {
  private static final DoubleFunction<String> FEW = value -> Numbers.significant(value, 2);

  private SearchPlots() {}

  private static PlotInk ink(SearchMode mode) {
    return switch (mode) {
      case DOUBLE -> PlotInk.SECOND;
      case SINGLE -> PlotInk.FIRST;
      case VERLET -> PlotInk.THIRD;
    };
  }

  /**
   * Speed-up over threads, by the cells that are the fastest with the most threads, beside the
   * ideal one.
   */
  static String speedUp(SearchResult result) {
    double most = Math.max(2, result.mostThreads());
    LogPlot plot =
        new LogPlot(
            "Speed-up over threads for each search of neighbours",
            LogPlot.Scale.around("threads", 1, most, FEW),
            LogPlot.Scale.around("speed-up over one thread", 0.5, most, FEW));
    plot.curve(new double[] {1, most}, new double[] {1, most}, PlotInk.GREY, "2 3");
    for (SearchMode mode : result.modes()) {
      double edge = result.best(mode, result.mostThreads()).orElseThrow().wantedEdge();
      List<SearchResult.Point> points =
          result.threads().stream().map(n -> result.at(mode, n, edge).orElseThrow()).toList();
      curve(
          plot,
          mode,
          points.stream().mapToDouble(SearchResult.Point::threads).toArray(),
          points.stream().mapToDouble(p -> result.speedUp(p).orElseThrow()).toArray());
    }
    plot.nameCurve("ideal", PlotInk.GREY, "2 3");
    return plot.toString();
  }

  /** Speed over the edge of a cell, with the most threads. */
  static String speedByEdge(SearchResult result) {
    int threads = result.mostThreads();
    List<SearchResult.Point> all =
        result.points().stream().filter(p -> p.threads() == threads).toList();
    LogPlot plot =
        new LogPlot(
            "Speed over the edge of a cell for each search of neighbours",
            LogPlot.Scale.around(
                "edge of a cell, distances of particles", least(all, false), most(all, false), FEW),
            LogPlot.Scale.around(
                "10^6 particle-steps/s, " + Numbers.threads(threads),
                least(all, true),
                most(all, true),
                FEW));
    for (SearchMode mode : result.modes()) {
      List<SearchResult.Point> points =
          result.wantedEdges().stream()
              .map(edge -> result.at(mode, threads, edge))
              .flatMap(Optional::stream)
              .toList();
      curve(
          plot,
          mode,
          points.stream().mapToDouble(SearchResult.Point::edge).toArray(),
          points.stream().mapToDouble(p -> 1e-6 * p.speed()).toArray());
    }
    return plot.toString();
  }

  private static double least(List<SearchResult.Point> points, boolean speed) {
    return points.stream()
        .mapToDouble(p -> speed ? 1e-6 * p.speed() : p.edge())
        .min()
        .orElseThrow();
  }

  private static double most(List<SearchResult.Point> points, boolean speed) {
    return points.stream()
        .mapToDouble(p -> speed ? 1e-6 * p.speed() : p.edge())
        .max()
        .orElseThrow();
  }

  private static void curve(LogPlot plot, SearchMode mode, double[] xs, double[] ys) {
    plot.curve(xs, ys, ink(mode), "");
    for (int n = 0; n < xs.length; n++) {
      plot.mark(xs[n], ys[n], Mark.CIRCLE, ink(mode));
    }
    plot.nameCurve(Choices.word(mode), ink(mode), "");
  }
}
