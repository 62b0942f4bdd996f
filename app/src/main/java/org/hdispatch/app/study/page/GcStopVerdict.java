package org.hdispatch.app.study.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.ScratchPolicy;
import org.hdispatch.app.study.page.GcRuns.Pair;
import org.hdispatch.app.study.page.GcRuns.Run;
import org.hdispatch.app.study.page.GcRuns.Setting;
import org.hdispatch.app.text.Numbers;

/** What stands still with scratch per cell, in sentences, in one setting of a study. */
final class GcStopVerdict {
  /** From this ratio of stopped time to pauses on, pauses do not tell all. */
  private static final double MORE = 1.1;

  private final GcRuns runs;
  private final GcPhrases phrases;
  private final Setting setting;

  GcStopVerdict(GcRuns runs, Setting setting) {
    this.runs = runs;
    phrases = new GcPhrases(runs);
    this.setting = setting;
  }

  private List<Run> perCell(double heap) {
    return runs.runs(setting, ScratchPolicy.PER_CELL).stream()
        .filter(run -> run.of().heapFactor() == heap)
        .toList();
  }

  /** For how long nobody works, and how much of that collectors report. */
  Optional<String> standstill() {
    List<String> shares = new ArrayList<>();
    for (double heap : runs.heaps(setting)) {
      List<Run> stopped = perCell(heap).stream().filter(Run::stopsMeasured).toList();
      if (!stopped.isEmpty()) {
        shares.add(
            GcPhrases.span(stopped, run -> 100 * run.stoppedShare())
                + " % of the time"
                + GcPhrases.inHeap(heap)
                + phrases.extremes(stopped, Run::stoppedShare));
      }
    }
    return shares.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "With scratch per cell all threads stand still for "
                + String.join("; for ", shares)
                + "."
                + beyondPauses());
  }

  private String beyondPauses() {
    ToDoubleFunction<Run> ratio =
        run -> run.figures().stopped().totalMillis() / run.figures().pauses().totalMillis();
    Optional<Run> most =
        runs.runs(setting, ScratchPolicy.PER_CELL).stream()
            .filter(Run::stopsMeasured)
            .filter(run -> run.figures().pauses().totalMillis() > 0)
            .max(Comparator.comparingDouble(ratio));
    return most.map(
            run ->
                ratio.applyAsDouble(run) > MORE
                    ? " The pauses that collectors report do not tell all of it: with "
                        + runs.name(run.of())
                        + GcPhrases.inHeap(run.of().heapFactor())
                        + " they sum up to "
                        + GcPhrases.millis(run.figures().pauses())
                        + " where threads were stopped for "
                        + GcPhrases.millis(run.figures().stopped())
                        + "."
                    : " The pauses that collectors report tell all of it.")
        .orElse("");
  }

  /** That short pauses are not all there is to ZGC. */
  Optional<String> stalls() {
    List<Run> all =
        runs.runs(setting, ScratchPolicy.PER_CELL).stream()
            .filter(run -> run.of().collector() == Collector.ZGC)
            .filter(run -> run.figures().pauses().count() >= 0)
            .filter(run -> run.figures().stalls().count() >= 0)
            .toList();
    if (all.isEmpty()) {
      return Optional.empty();
    }
    List<String> waits = new ArrayList<>();
    for (double heap : runs.heaps(setting)) {
      List<Run> stalled =
          all.stream()
              .filter(run -> run.of().heapFactor() == heap)
              .filter(run -> run.figures().stalls().count() > 0)
              .toList();
      if (!stalled.isEmpty()) {
        waits.add(
            GcPhrases.span(stalled, run -> run.figures().stalls().count())
                + " times"
                + GcPhrases.inHeap(heap)
                + " ("
                + GcPhrases.span(stalled, run -> run.figures().stalls().totalMillis())
                + " ms in all, "
                + GcPhrases.span(stalled, run -> run.figures().stalls().maxMillis())
                + " ms at most)");
      }
    }
    double longest =
        all.stream().mapToDouble(run -> run.figures().pauses().maxMillis()).max().orElse(0);
    return Optional.of(
        (longest > 0
                ? "No pause of ZGC is longer than " + Numbers.plain(longest, 2) + " ms, "
                : "ZGC did not pause, ")
            + (waits.isEmpty()
                ? "and no worker waited for memory."
                : "but workers waited for memory, which no pause counts: "
                    + String.join("; ", waits)
                    + "."));
  }

  /** What that does to the longest steps. */
  Optional<String> tails() {
    List<String> said = new ArrayList<>();
    for (double heap : runs.heaps(setting)) {
      List<Pair> pairs =
          runs.pairs(setting, ScratchPolicy.PER_CELL, heap).stream()
              .filter(pair -> pair.enduring().figures().stepTimes().p90Micros() > 0)
              .toList();
      if (!pairs.isEmpty()) {
        said.add(
            GcPhrases.times(pairs, Pair::tailRatio)
                + " as long"
                + GcPhrases.inHeap(heap)
                + phrases.extremes(pairs, Pair::tailRatio));
      }
    }
    return said.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "Against enduring scratch the 90th percentile of the step time is "
                + String.join("; ", said)
                + ".");
  }
}
