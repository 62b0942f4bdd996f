package org.hdispatch.app.study.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.Lbo;
import org.hdispatch.app.study.ScratchPolicy;
import org.hdispatch.app.study.page.GcRuns.Pair;
import org.hdispatch.app.study.page.GcRuns.Setting;
import org.hdispatch.app.text.Numbers;

/** What ways to keep scratch cost in processor time, in sentences, in one setting of a study. */
final class GcPriceVerdict {
  /** Scratch for which a cost was expected. */
  private static final int EXPECTED_SCRATCH = 64 << 10;

  /** Processor time over enduring scratch that was expected, by the size of the heap. */
  private static final Map<Double, Double> EXPECTED = Map.of(6.0, 1.2, 2.0, 1.5);

  /** Up to this ratio a policy is nearly as cheap. */
  private static final double NEARLY = 1.1;

  /** From this share of the cost per cell on, a policy is no better than that. */
  private static final double NO_BETTER = 0.9;

  private final GcRuns runs;
  private final GcPhrases phrases;
  private final Setting setting;
  private final List<Double> heaps; // those with scratch per cell beside enduring scratch

  GcPriceVerdict(GcRuns runs, Setting setting) {
    this.runs = runs;
    phrases = new GcPhrases(runs);
    this.setting = setting;
    heaps = runs.heaps(setting).stream().filter(heap -> !perCell(heap).isEmpty()).toList();
  }

  private List<Pair> perCell(double heap) {
    return runs.pairs(setting, ScratchPolicy.PER_CELL, heap);
  }

  /** What scratch per cell costs in each heap, and who pays. */
  List<String> perCell() {
    List<String> said = new ArrayList<>();
    for (double heap : heaps) {
      List<Pair> pairs = perCell(heap);
      String cost =
          said.isEmpty()
              ? "Scratch made anew for every cell ("
                  + setting.name()
                  + ") costs "
                  + GcPhrases.costs(pairs)
                  + " the CPU of enduring scratch"
                  + GcPhrases.inHeap(heap)
                  + " the smallest that runs"
              : "It costs " + GcPhrases.costs(pairs) + GcPhrases.inHeap(heap);
      said.add(cost + phrases.extremes(pairs, Pair::ratio) + "." + expected(heap, pairs));
    }
    if (!heaps.isEmpty()) {
      said.add(inMicros());
      division().ifPresent(said::add);
    }
    return said;
  }

  private String expected(double heap, List<Pair> pairs) {
    if (setting.scratchBytes() != EXPECTED_SCRATCH || !EXPECTED.containsKey(heap)) {
      return "";
    }
    List<Pair> less = less(heap);
    String where =
        less.size() == pairs.size() && pairs.size() > 1
            ? "anywhere."
            : "with " + phrases.named(less, Pair::ratio) + ".";
    return " At least "
        + Numbers.plain(EXPECTED.get(heap), 2)
        + " was expected, and "
        + (less.isEmpty() ? "seen." : "not seen " + where);
  }

  /** Those that cost less than was expected. */
  private List<Pair> less(double heap) {
    return setting.scratchBytes() == EXPECTED_SCRATCH
        ? perCell(heap).stream()
            .filter(pair -> pair.ratio() < EXPECTED.getOrDefault(heap, 0.0))
            .toList()
        : List.of();
  }

  private String inMicros() {
    double heap = heaps.get(0);
    List<Pair> pairs = perCell(heap);
    boolean missed = heaps.stream().anyMatch(each -> !less(each).isEmpty());
    return "Each new "
        + Numbers.bytes(setting.scratchBytes())
        + " takes "
        + GcPhrases.span(pairs, Pair::extra)
        + " us of CPU more, where a cell with enduring scratch takes "
        + GcPhrases.span(pairs, pair -> pair.enduring().cpu())
        + " us"
        + GcPhrases.inHeap(heap)
        + "."
        + (missed ? " The more there is to do in a cell, the less that weighs." : "");
  }

  /** Whether the workers or the collector pay. */
  private Optional<String> division() {
    List<String> shares = new ArrayList<>();
    List<String> collectors = new ArrayList<>();
    double roomy = 0;
    for (double heap : heaps) {
      double extra = perCell(heap).stream().mapToDouble(Pair::extra).sum();
      if (extra > 0) {
        double share = share(heap, Pair::extraOfWorkers);
        roomy = heap == heaps.get(0) ? share : roomy;
        shares.add(percent(share, heap));
        if (perCell(heap).stream().allMatch(Pair::knowsCollector)) {
          collectors.add(percent(share(heap, Pair::extraOfCollector), heap));
        }
      }
    }
    return shares.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "Of what this costs, over all collectors, the workers themselves spend "
                + String.join(" and ", shares)
                + (collectors.size() < shares.size()
                    ? "; the rest is other threads', the collector's above all."
                    : ", the collector's threads "
                        + String.join(" and ", collectors)
                        + "; the rest is the compilers' and the recorder's.")
                + (roomy > 0.5
                    ? " So with room in the heap most of the price is paid by the threads that step:"
                        + " they zero each new scratch, stream it through their caches, and pass the"
                        + " collector's barriers, which is not told apart here."
                    : ""));
  }

  /** Part of what scratch per cell costs more, over all collectors. */
  private double share(double heap, ToDoubleFunction<Pair> part) {
    double extra = perCell(heap).stream().mapToDouble(Pair::extra).sum();
    return Math.max(0, Math.min(1, perCell(heap).stream().mapToDouble(part).sum() / extra));
  }

  private static String percent(double share, double heap) {
    return Math.round(100 * share) + " %" + GcPhrases.inHeap(heap);
  }

  /** What other ways to keep scratch cost, that should be nearly as cheap. */
  Optional<String> alternatives() {
    Map<ScratchPolicy, String> names = new LinkedHashMap<>();
    names.put(ScratchPolicy.PER_STEP, "made anew for every step");
    names.put(
        ScratchPolicy.THREAD_LOCAL_POOL,
        "in a ThreadLocal of a pool's threads, with a task of the JDK for each cell");
    names.put(ScratchPolicy.OBJECT_POOL, "borrowed from an object pool");
    List<String> said = new ArrayList<>();
    List<Pair> all = new ArrayList<>();
    names.forEach(
        (policy, name) -> {
          List<Pair> pairs = runs.pairs(setting, policy);
          if (!pairs.isEmpty()) {
            all.addAll(pairs);
            String cost = GcPhrases.costs(pairs);
            said.add(name + ", " + cost + GcPhrases.allocated(pairs));
          }
        });
    double nearly = Math.max(NEARLY, runs.noise(setting));
    List<Pair> dear = all.stream().filter(pair -> pair.ratio() > nearly).toList();
    boolean allocate =
        all.stream()
            .allMatch(
                pair -> pair.other().bytesPerStep() > 0 && pair.enduring().bytesPerStep() == 0);
    return said.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "Scratch kept otherwise, CPU over enduring scratch: "
                + String.join("; ", said)
                + ". "
                + (dear.isEmpty()
                    ? "That is nearly as cheap"
                        + (allocate ? "; what enduring scratch adds is exactly 0 bytes." : ".")
                    : "Dearer by more than runs differ by themselves: " + dearest(dear) + "."));
  }

  private String dearest(List<Pair> dear) {
    return GcPhrases.some(
        dear.stream()
            .map(
                pair ->
                    GcRuns.policy(pair.of().policy())
                        + " with "
                        + runs.name(pair.of())
                        + GcPhrases.inHeap(pair.of().heapFactor())
                        + " ("
                        + Numbers.ratio(pair.ratio())
                        + ")")
            .toList());
  }

  /** How often each case was run, and how much the same work takes more in one than in another. */
  Optional<String> noise() {
    if (heaps.isEmpty()) {
      return Optional.empty();
    }
    double noise = runs.noise(setting);
    boolean once = runs.repeats().getMax() == 1;
    String known =
        noise == 1
            ? ""
            : " The same work with enduring scratch, on the same JVM and collector, without any"
                + " collection, took up to "
                + Numbers.ratio(noise)
                + " times as much CPU in one "
                + (once ? "run" : "median")
                + " as in another: ratios closer to 1 mean nothing, and who is least or most may be"
                + " chance.";
    return Optional.of(
        "What these ratios can tell: "
            + (once ? "each case was run once." : "they are medians of " + spread())
            + known);
  }

  /** Of how many runs, and how far these lie apart. */
  private String spread() {
    List<Pair> pairs = heaps.stream().flatMap(heap -> perCell(heap).stream()).toList();
    Pair widest =
        pairs.stream()
            .max(Comparator.comparingDouble(pair -> pair.mostRatio() / pair.leastRatio()))
            .orElseThrow();
    return runs.repeatsInWords()
        + " runs of each case, in rounds over all cases; from round to round a ratio per cell"
        + " differs most with "
        + runs.name(widest.of())
        + GcPhrases.inHeap(widest.of().heapFactor())
        + ", "
        + Numbers.ratio(widest.leastRatio())
        + " to "
        + Numbers.ratio(widest.mostRatio())
        + ".";
  }

  /** What a ThreadLocal costs where each cell has a virtual thread. */
  Optional<String> virtualThreads() {
    List<Pair> pairs = runs.pairs(setting, ScratchPolicy.THREAD_LOCAL_VIRTUAL);
    if (pairs.isEmpty()) {
      return Optional.empty();
    }
    List<Pair> beside = pairs.stream().flatMap(pair -> perCellLike(pair.of()).stream()).toList();
    boolean noBetter =
        !beside.isEmpty()
            && pairs.stream()
                .allMatch(
                    pair ->
                        perCellLike(pair.of())
                            .map(
                                cell ->
                                    cell.ratio() > NEARLY
                                        && pair.ratio() >= NO_BETTER * cell.ratio())
                            .orElse(true));
    return Optional.of(
        "A ThreadLocal of virtual threads, one for each cell, costs "
            + GcPhrases.costs(pairs)
            + " the CPU of enduring scratch"
            + GcPhrases.allocated(pairs)
            + (beside.isEmpty() ? "" : ", where scratch per cell costs " + GcPhrases.costs(beside))
            + (noBetter ? ": it is scratch per cell by another name." : "."));
  }

  private Optional<Pair> perCellLike(GcCase of) {
    return perCell(of.heapFactor()).stream()
        .filter(pair -> pair.of().java().equals(of.java()))
        .filter(pair -> pair.of().collector() == of.collector())
        .findFirst();
  }

  /** What enduring scratch and scratch per cell cost over the distilled baseline. */
  Optional<String> overBaseline() {
    Lbo lbo = Lbo.of(runs.rows());
    List<Double> enduring = costs(lbo, ScratchPolicy.ENDURING);
    List<Double> perCell = costs(lbo, ScratchPolicy.PER_CELL);
    return enduring.isEmpty() || perCell.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "Over the distilled baseline (LBO: the least CPU that the workers took in any run on the"
                + " same JVM) enduring scratch costs "
                + GcPhrases.times(enduring, each -> each)
                + ", scratch per cell "
                + GcPhrases.times(perCell, each -> each)
                + ".");
  }

  private List<Double> costs(Lbo lbo, ScratchPolicy policy) {
    return runs.runs(setting, policy).stream()
        .map(run -> lbo.cost(run.of(), run.figures()))
        .filter(OptionalDouble::isPresent)
        .map(OptionalDouble::getAsDouble)
        .toList();
  }
}
