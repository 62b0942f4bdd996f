package org.hdispatch.app.study.page;

import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcFigures.Stops;
import org.hdispatch.app.study.page.GcRuns.Measured;
import org.hdispatch.app.study.page.GcRuns.Pair;
import org.hdispatch.app.text.Numbers;

/** Phrases about runs of a study of garbage collection. */
final class GcPhrases {
  /** What is named of many; the table has the others. */
  private static final int NAMED = 8;

  private final GcRuns runs;

  GcPhrases(GcRuns runs) {
    this.runs = runs;
  }

  /** The size of a heap. */
  static String inHeap(double factor) {
    return " in a heap of " + GcRuns.heap(factor);
  }

  /** The first few. */
  static String some(List<String> all) {
    return all.size() <= NAMED
        ? String.join("; ", all)
        : String.join("; ", all.subList(0, NAMED))
            + "; and "
            + (all.size() - NAMED)
            + " more, in the table";
  }

  /** What values lie between. */
  static <T> String span(List<T> all, ToDoubleFunction<T> what) {
    double[] values = all.stream().mapToDouble(what).sorted().toArray();
    return Numbers.span(values[0], values[values.length - 1], 3);
  }

  /** What ratios lie between. */
  static <T> String times(List<T> all, ToDoubleFunction<T> ratio) {
    double[] values = all.stream().mapToDouble(ratio).sorted().toArray();
    String least = Numbers.ratio(values[0]);
    String most = Numbers.ratio(values[values.length - 1]);
    return (least.equals(most) ? least : least + " to " + most) + " times";
  }

  /** What ways to keep scratch take over enduring scratch; medians, and single runs too. */
  static String costs(List<Pair> pairs) {
    double least = pairs.stream().mapToDouble(Pair::leastRatio).min().orElseThrow();
    double most = pairs.stream().mapToDouble(Pair::mostRatio).max().orElseThrow();
    return times(pairs, Pair::ratio)
        + (pairs.stream().allMatch(pair -> pair.rounds().size() == 1)
            ? ""
            : " (single runs " + Numbers.ratio(least) + " to " + Numbers.ratio(most) + ")");
  }

  /** Who is least and most; who it is, if it is but one. */
  <T extends Measured> String extremes(List<T> all, ToDoubleFunction<T> what) {
    if (all.size() == 1) {
      return " (" + runs.name(all.get(0).of()) + ")";
    }
    Comparator<T> order = Comparator.comparingDouble(what);
    return ", least with "
        + runs.name(all.stream().min(order).orElseThrow().of())
        + ", most with "
        + runs.name(all.stream().max(order).orElseThrow().of());
  }

  /** Who, each with its ratio. */
  <T extends Measured> String named(List<T> all, ToDoubleFunction<T> ratio) {
    return some(
        all.stream()
            .map(
                each ->
                    runs.name(each.of()) + " (" + Numbers.ratio(ratio.applyAsDouble(each)) + ")")
            .toList());
  }

  /** What was run, in full. */
  String full(GcCase of) {
    return runs.name(of) + ", " + GcRuns.Setting.of(of).name() + "," + inHeap(of.heapFactor());
  }

  /** How long stops took in all. */
  static String millis(Stops stops) {
    return Numbers.plain(stops.totalMillis(), 3) + " ms";
  }

  /** What runs allocate, if that was measured. */
  static String allocated(List<Pair> pairs) {
    double[] bytes =
        pairs.stream()
            .mapToDouble(pair -> pair.other().bytesPerStep())
            .filter(each -> each >= 0)
            .sorted()
            .toArray();
    if (bytes.length == 0) {
      return "";
    }
    String least = Numbers.bytes(bytes[0]);
    String most = Numbers.bytes(bytes[bytes.length - 1]);
    return " (" + (least.equals(most) ? least : least + " to " + most) + " per step)";
  }
}
