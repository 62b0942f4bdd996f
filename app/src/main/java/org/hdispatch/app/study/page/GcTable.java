package org.hdispatch.app.study.page;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcFigures;
import org.hdispatch.app.study.GcFigures.Stops;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.Lbo;
import org.hdispatch.app.study.page.GcRuns.Round;
import org.hdispatch.app.study.page.GcRuns.Run;
import org.hdispatch.app.study.page.GcRuns.Setting;
import org.hdispatch.app.text.Numbers;

/** The rows of a study of garbage collection as rows of a table. */
final class GcTable {
  /** What the columns are. */
  static final List<String> HEAD =
      List.of(
          "collector, scratch",
          "steps/s",
          "workers' CPU, us/cell",
          "others' CPU, us/cell",
          "of it the collector's",
          "over enduring",
          "LBO",
          "collec\u00adtions",
          "pauses, ms",
          "their p99, ms",
          "longest, ms",
          "stopped, ms",
          "to safe\u00adpoint, ms",
          "stalls",
          "stalls, ms",
          "median step, ms",
          "p99, ms",
          "p99.9, ms",
          "longest, ms",
          "made per step and worker",
          "peak / heap, MiB");

  private static final String NONE = "\u2013";
  private static final double MIB = 1 << 20;

  private final GcRuns runs;
  private final Lbo lbo;

  GcTable(GcRuns runs) {
    this.runs = runs;
    lbo = Lbo.of(runs.rows());
  }

  /** All rows of a setting, below a heading for each JVM and size of the heap. */
  List<List<String>> rows(Setting setting) {
    List<List<String>> table = new ArrayList<>();
    for (String java : runs.javas()) {
      for (double heap : runs.heaps(setting)) {
        List<GcCase> cases = runs.cases(setting, java, heap);
        if (!cases.isEmpty()) {
          table.add(List.of("Java " + java + ", heap of " + GcRuns.heap(heap)));
        }
        for (GcCase of : cases) {
          runs.rows().stream()
              .filter(row -> row.of().equals(of))
              .map(this::row)
              .forEach(table::add);
        }
      }
    }
    return table;
  }

  private List<String> row(GcRow row) {
    String name =
        row.of().collector().title()
            + ", "
            + GcRuns.policy(row.of().policy())
            + (runs.repeats().getMax() > 1 ? ", run " + row.fork() : "");
    return GcRuns.run(row)
        .map(run -> measured(name, row, run))
        .orElseGet(() -> List.of(name, "no figures: " + GcRuns.why(row)));
  }

  private List<String> measured(String name, GcRow row, Run run) {
    GcFigures figures = run.figures();
    Optional<Round> round = runs.round(run);
    List<String> cells = new ArrayList<>();
    cells.add(name);
    cells.add(number(figures.steps() / figures.seconds()));
    cells.add(number(run.workers()));
    cells.add(number(run.others()));
    cells.add(number(run.collector()));
    cells.add(round.map(each -> Numbers.ratio(each.ratio())).orElse(NONE));
    cells.add(lbo.cost(row).stream().mapToObj(Numbers::ratio).findFirst().orElse(NONE));
    cells.add(number(figures.collections()));
    cells.addAll(stops(figures.pauses()));
    cells.add(stops(figures.stopped()).get(0));
    cells.add(figures.stopped().count() < 0 ? NONE : number(figures.reachingMillis()));
    cells.add(number(figures.stalls().count()));
    cells.add(stops(figures.stalls()).get(0));
    cells.add(number(1e-3 * figures.stepTimes().p50Micros()));
    cells.add(number(1e-3 * figures.stepTimes().p99Micros()));
    cells.add(number(1e-3 * figures.stepTimes().p999Micros()));
    cells.add(number(1e-3 * figures.stepTimes().maxMicros()));
    cells.add(figures.bytesPerStep() < 0 ? NONE : Numbers.bytes(figures.bytesPerStep()));
    cells.add(whole(figures.peakHeapBytes() / MIB) + " / " + whole(figures.heapBytes() / MIB));
    return cells;
  }

  /** Sum, 99th percentile and longest. */
  private static List<String> stops(Stops stops) {
    return stops.count() < 0
        ? List.of(NONE, NONE, NONE)
        : List.of(
            number(stops.totalMillis()), number(stops.p99Millis()), number(stops.maxMillis()));
  }

  private static String whole(double value) {
    return value < 0 ? NONE : Long.toString(Math.round(value));
  }

  /** Three digits at least; what was not measured is negative. */
  private static String number(double value) {
    if (!Double.isFinite(value) || value < 0) {
      return NONE;
    }
    return value >= 100 ? Long.toString(Math.round(value)) : Numbers.plain(value, 3);
  }
}
