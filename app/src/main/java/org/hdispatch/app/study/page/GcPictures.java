package org.hdispatch.app.study.page;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hdispatch.app.draw.BarPlot;
import org.hdispatch.app.draw.LanePlot;
import org.hdispatch.app.draw.LinearAxis;
import org.hdispatch.app.draw.LogPlot;
import org.hdispatch.app.draw.PlotAxis;
import org.hdispatch.app.draw.PlotInk;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcFigures;
import org.hdispatch.app.study.GcFigures.Pause;
import org.hdispatch.app.study.GcFigures.StepTimes;
import org.hdispatch.app.study.ScratchPolicy;
import org.hdispatch.app.study.page.GcRuns.Pair;
import org.hdispatch.app.study.page.GcRuns.Run;
import org.hdispatch.app.study.page.GcRuns.Setting;
import org.hdispatch.app.text.Numbers;

/** The pictures of one setting of a study of garbage collection; each has one JVM and one heap. */
final class GcPictures {
  private static final int PAUSE_LANE = 46;
  private static final int STEP_LANE = 60;

  /** Where one step is still to be seen on an axis of counts. */
  private static final double BELOW_ONE = 0.6;

  /** Upper edge over lower edge of a class that is the only one. */
  private static final double LONE_CLASS = 1.1;

  private final GcRuns runs;
  private final Setting setting;

  GcPictures(GcRuns runs, Setting setting) {
    this.runs = runs;
    this.setting = setting;
  }

  static PlotInk ink(ScratchPolicy policy) {
    return switch (policy) {
      case ENDURING -> PlotInk.FIRST;
      case PER_CELL -> PlotInk.SECOND;
      default -> PlotInk.THIRD;
    };
  }

  private Stream<Run> measured() {
    return runs.runs().stream().filter(run -> Setting.of(run.of()).equals(setting));
  }

  private Optional<GcFigures> figures(
      Collector collector, ScratchPolicy policy, String java, double heap) {
    return runs.run(
            new GcCase(java, collector, policy, setting.workload(), setting.scratchBytes(), heap))
        .map(Run::figures);
  }

  private String heading(String java, double heap) {
    return runs.javaName(java) + ", heap of " + GcRuns.heap(heap);
  }

  /** A picture for each JVM and these heaps where something was measured. */
  private List<String> each(List<Double> heaps, Function<List<GcCase>, String> draw) {
    List<String> pictures = new ArrayList<>();
    for (String java : runs.javas()) {
      for (double heap : heaps) {
        List<GcCase> cases = runs.cases(setting, java, heap);
        if (cases.stream().anyMatch(of -> runs.run(of).isPresent())) {
          pictures.add(draw.apply(cases));
        }
      }
    }
    return pictures;
  }

  /**
   * Processor time per cell, by collector and policy.
   *
   * @param heaps sizes of the heap to be shown
   */
  List<String> bars(List<Double> heaps) {
    double most = measured().mapToDouble(Run::cpu).max().orElse(0);
    PlotAxis axis = new LinearAxis("CPU, \u00b5s per cell", most > 0 ? most : 1);
    return each(
        heaps,
        cases -> {
          List<BarPlot.Group> groups = new ArrayList<>();
          for (Collector collector : collectors(cases)) {
            groups.add(
                new BarPlot.Group(
                    collector.title(),
                    cases.stream()
                        .filter(of -> of.collector() == collector)
                        .map(this::bar)
                        .toList()));
          }
          return BarPlot.of(heading(cases), "other threads", axis, groups);
        });
  }

  private String heading(List<GcCase> cases) {
    return heading(cases.get(0).java(), cases.get(0).heapFactor());
  }

  private static List<Collector> collectors(List<GcCase> cases) {
    return cases.stream().map(GcCase::collector).distinct().toList();
  }

  private BarPlot.Bar bar(GcCase of) {
    String name = GcRuns.policy(of.policy());
    PlotInk ink = ink(of.policy());
    return runs.run(of)
        .map(run -> new BarPlot.Bar(name, run.workers(), run.others(), note(run), ink))
        .orElseGet(() -> new BarPlot.Bar(name, 0, 0, "no figures", ink));
  }

  private String note(Run run) {
    String cpu = Numbers.plain(run.cpu(), 3);
    Optional<Pair> pair = runs.pair(run);
    return pair.isEmpty() || run.of().policy() == ScratchPolicy.ENDURING
        ? cpu
        : cpu + " (" + Numbers.ratio(pair.get().ratio()) + "x)";
  }

  /** Collectors that ran with enduring scratch or per cell. */
  private List<Collector> compared(List<GcCase> cases) {
    return collectors(
        cases.stream()
            .filter(
                of ->
                    of.policy() == ScratchPolicy.ENDURING || of.policy() == ScratchPolicy.PER_CELL)
            .toList());
  }

  /** Pauses over time, with scratch per cell and, below, with enduring scratch. */
  List<String> pauses() {
    List<Double> all = runs.heaps(setting);
    List<Double> heaps = all.size() < 2 ? all : List.of(all.get(0), all.get(all.size() - 1));
    double[] millis =
        measured()
            .flatMap(run -> run.figures().timeline().stream())
            .mapToDouble(Pause::millis)
            .filter(each -> each > 0)
            .sorted()
            .toArray();
    double seconds = measured().mapToDouble(run -> run.figures().seconds()).max().orElse(1);
    PlotAxis y =
        LogPlot.Scale.decades(
            "ms",
            millis.length == 0 ? 1 : millis[0],
            millis.length == 0 ? 1 : millis[millis.length - 1],
            value -> Numbers.plain(value, 1));
    PlotAxis x = new LinearAxis("seconds after warm-up", seconds);
    return each(
        heaps,
        cases -> {
          List<Collector> collectors = compared(cases);
          LanePlot plot =
              new LanePlot(
                  heading(cases), collectors.size(), PAUSE_LANE, LanePlot.Strips.WITH, x, y);
          plot.name("per cell", ink(ScratchPolicy.PER_CELL));
          plot.name("enduring", ink(ScratchPolicy.ENDURING));
          for (Collector collector : collectors) {
            pauses(plot, cases.get(0), collector);
          }
          return plot.toString();
        });
  }

  private void pauses(LanePlot plot, GcCase like, Collector collector) {
    Optional<GcFigures> anew =
        figures(collector, ScratchPolicy.PER_CELL, like.java(), like.heapFactor());
    plot.lane(collector.title(), anew.map(GcPictures::pauseNote).orElse(""));
    if (anew.isEmpty()) {
      plot.nothing("no figures per cell");
    } else {
      GcFigures each = anew.get();
      plot.ticks(
          pauses(each, Pause::atSeconds),
          pauses(each, Pause::millis),
          each.seconds(),
          ink(ScratchPolicy.PER_CELL));
    }
    figures(collector, ScratchPolicy.ENDURING, like.java(), like.heapFactor())
        .ifPresent(
            each ->
                plot.strip(
                    "enduring",
                    pauses(each, Pause::atSeconds),
                    pauses(each, Pause::millis),
                    each.seconds(),
                    ink(ScratchPolicy.ENDURING)));
  }

  private static double[] pauses(GcFigures figures, Function<Pause, Double> what) {
    return figures.timeline().stream().mapToDouble(what::apply).toArray();
  }

  private static String pauseNote(GcFigures figures) {
    GcFigures.Stops pauses = figures.pauses();
    long stalls = figures.stalls().count();
    String waits = stalls > 0 ? "; " + GcRuns.count(stalls, "stall") : "";
    if (pauses.count() < 0) {
      return "pauses not measured" + waits;
    }
    return pauses.count() == 0
        ? "no pause" + waits
        : GcRuns.count(pauses.count(), "pause")
            + ", "
            + Numbers.plain(pauses.totalMillis(), 3)
            + " ms; longest "
            + Numbers.plain(pauses.maxMillis(), 2)
            + " ms"
            + waits;
  }

  /** How long steps took, with enduring scratch and per cell. */
  List<String> steps() {
    List<StepTimes> all =
        measured()
            .filter(
                run ->
                    run.of().policy() == ScratchPolicy.ENDURING
                        || run.of().policy() == ScratchPolicy.PER_CELL)
            .map(run -> run.figures().stepTimes())
            .filter(times -> !times.edgesMicros().isEmpty())
            .toList();
    double[] edges =
        all.stream()
            .flatMapToDouble(GcPictures::filled)
            .filter(edge -> edge > 0)
            .sorted()
            .toArray();
    if (edges.length == 0) {
      return List.of();
    }
    double most =
        all.stream()
            .flatMap(times -> times.counts().stream())
            .mapToDouble(Long::doubleValue)
            .max()
            .orElse(1);
    PlotAxis x =
        LogPlot.Scale.around(
            "step time, ms",
            1e-3 * edges[0],
            1e-3 * edges[edges.length - 1],
            value -> Numbers.plain(value, 3));
    PlotAxis y =
        new LogPlot.Scale("steps", BELOW_ONE, Math.max(10, most), value -> Numbers.plain(value, 3));
    return each(
        runs.heaps(setting),
        cases -> {
          List<Collector> collectors = compared(cases);
          LanePlot plot =
              new LanePlot(
                  heading(cases), collectors.size(), STEP_LANE, LanePlot.Strips.WITHOUT, x, y);
          plot.name("enduring", ink(ScratchPolicy.ENDURING));
          plot.name("per cell", ink(ScratchPolicy.PER_CELL));
          for (Collector collector : collectors) {
            steps(plot, cases.get(0), collector);
          }
          return plot.toString();
        });
  }

  private void steps(LanePlot plot, GcCase like, Collector collector) {
    List<String> tails = new ArrayList<>();
    Optional<GcFigures> enduring =
        figures(collector, ScratchPolicy.ENDURING, like.java(), like.heapFactor());
    Optional<GcFigures> anew =
        figures(collector, ScratchPolicy.PER_CELL, like.java(), like.heapFactor());
    for (Optional<GcFigures> each : List.of(enduring, anew)) {
      tails.add(each.map(f -> Numbers.plain(1e-3 * f.stepTimes().p90Micros(), 3)).orElse("\u2013"));
    }
    plot.lane(collector.title(), "p90: " + String.join(" and ", tails) + " ms");
    anew.ifPresent(each -> outline(plot, each.stepTimes(), ink(ScratchPolicy.PER_CELL)));
    enduring.ifPresent(each -> outline(plot, each.stepTimes(), ink(ScratchPolicy.ENDURING)));
  }

  private static void outline(LanePlot plot, StepTimes times, PlotInk ink) {
    if (!times.edgesMicros().isEmpty()) {
      double[] edges = edges(times);
      for (int n = 0; n < edges.length; n++) {
        edges[n] *= 1e-3;
      }
      plot.outline(edges, times.counts().stream().mapToDouble(Long::doubleValue).toArray(), ink);
    }
  }

  /** All edges, us: the classes have but their upper ones. */
  private static double[] edges(StepTimes times) {
    List<Double> upper = times.edgesMicros();
    double first = upper.get(0);
    double[] edges = new double[upper.size() + 1];
    edges[0] = upper.size() > 1 ? first * first / upper.get(1) : first / LONE_CLASS;
    for (int n = 0; n < upper.size(); n++) {
      edges[n + 1] = upper.get(n);
    }
    return edges;
  }

  /** Where classes that hold a step begin and end, us. */
  private static DoubleStream filled(StepTimes times) {
    double[] edges = edges(times);
    return IntStream.range(0, times.counts().size())
        .filter(n -> times.counts().get(n) > 0)
        .boxed()
        .flatMapToDouble(n -> DoubleStream.of(edges[n], edges[n + 1]));
  }
}
