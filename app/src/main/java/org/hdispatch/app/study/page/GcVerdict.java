package org.hdispatch.app.study.page;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.ScratchPolicy;
import org.hdispatch.app.study.Workload;
import org.hdispatch.app.study.page.GcRuns.Pair;
import org.hdispatch.app.study.page.GcRuns.Run;
import org.hdispatch.app.study.page.GcRuns.Setting;
import org.hdispatch.app.text.Numbers;

/**
 * What follows from a study of garbage collection, in sentences. Each is there only if the rows it
 * speaks of are.
 */
public final class GcVerdict {
  /** Scratch that is humongous to G1 in heaps up to {@link #SMALL_REGIONS}. */
  private static final int HUMONGOUS = 1 << 20;

  /** Heap of 2048 regions of 2 MiB; an object that takes half a region is humongous. */
  private static final long SMALL_REGIONS = 4L << 30;

  private final GcRuns runs;
  private final GcPhrases phrases;

  private GcVerdict(GcRuns runs) {
    this.runs = runs;
    phrases = new GcPhrases(runs);
  }

  /**
   * What these rows say, most important first.
   *
   * @param rows of a study, at least one
   */
  public static List<String> sentences(List<GcRow> rows) {
    return new GcVerdict(new GcRuns(rows)).sentences();
  }

  private List<String> sentences() {
    Setting main = runs.settings().get(0);
    GcPriceVerdict price = new GcPriceVerdict(runs, main);
    GcStopVerdict stops = new GcStopVerdict(runs, main);
    List<String> said = new ArrayList<>();
    enduring().ifPresent(said::add);
    said.addAll(price.perCell());
    price.noise().ifPresent(said::add);
    origins().ifPresent(said::add);
    Stream.of(
            stops.standstill(),
            stops.stalls(),
            stops.tails(),
            price.alternatives(),
            price.virtualThreads(),
            humongous(),
            otherSettings(),
            price.overBaseline(),
            dead())
        .flatMap(Optional::stream)
        .forEach(said::add);
    return said;
  }

  private Optional<String> enduring() {
    List<Run> all =
        runs.singles().stream().filter(run -> run.of().policy() == ScratchPolicy.ENDURING).toList();
    if (all.isEmpty()) {
      return Optional.empty();
    }
    List<Run> except = all.stream().filter(GcVerdict::reclaims).toList();
    boolean grows = except.stream().anyMatch(run -> run.of().workload() == Workload.SPH);
    long unknown = all.stream().filter(run -> run.bytesPerStep() < 0).count();
    String said =
        "Enduring scratch: no collection, no pause and 0 bytes per step in "
            + (except.isEmpty()
                ? (all.size() > 1 ? "all " : "") + GcRuns.count(all.size(), "run")
                : all.size() - except.size() + " of " + GcRuns.count(all.size(), "run"))
            + (unknown == 0 ? "" : " (bytes not measured in " + unknown + ")")
            + ", with "
            + names(all, run -> run.of().collector().title())
            + " on "
            + names(all, run -> runs.javaName(run.of().java()))
            + ".";
    return Optional.of(
        except.isEmpty()
            ? said
            : said
                + " The exceptions: "
                + GcPhrases.some(
                    except.stream()
                        .map(run -> phrases.full(run.of()) + ": " + reclaimed(run))
                        .toList())
                + "."
                + (grows
                    ? " Cells of particles grow when they hold more than ever before, more and more"
                        + " seldom."
                    : ""));
  }

  /** That rows may differ by what made them. */
  private Optional<String> origins() {
    long builds = runs.rows().stream().map(row -> row.origin().build()).distinct().count();
    long machines = runs.rows().stream().map(row -> row.origin().machine()).distinct().count();
    return builds == 1 && machines == 1
        ? Optional.empty()
        : Optional.of(
            "These runs are of "
                + GcRuns.count(builds, "build")
                + " on "
                + GcRuns.count(machines, "machine")
                + ": what differs may differ by that.");
  }

  private static <T> String names(List<T> all, Function<T, String> name) {
    List<String> names = all.stream().map(name).distinct().toList();
    int last = names.size() - 1;
    return last == 0
        ? names.get(0)
        : String.join(", ", names.subList(0, last)) + " and " + names.get(last);
  }

  private static boolean reclaims(Run run) {
    return run.figures().collections() > 0
        || run.figures().pauses().count() > 0
        || run.bytesPerStep() > 0;
  }

  private static String reclaimed(Run run) {
    return GcRuns.count(run.figures().collections(), "collection")
        + ", "
        + GcRuns.count(Math.max(0, run.figures().pauses().count()), "pause")
        + (run.bytesPerStep() < 0 ? "" : ", " + Numbers.bytes(run.bytesPerStep()) + " per step");
  }

  private static boolean isHumongous(Run run) {
    return run.of().collector() == Collector.G1
        && run.of().policy() == ScratchPolicy.PER_CELL
        && run.of().scratchBytes() == HUMONGOUS
        && run.figures().heapBytes() <= SMALL_REGIONS;
  }

  /** The case of G1 that compares with the large-object heap of .NET. */
  private Optional<String> humongous() {
    List<String> said =
        runs.runs().stream().filter(GcVerdict::isHumongous).map(this::humongous).toList();
    return said.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "Scratch of 1 MiB per cell is humongous to G1, which gives each its own regions: "
                + GcPhrases.some(said)
                + ".");
  }

  private String humongous(Run run) {
    String cost =
        runs.pair(run).map(pair -> Numbers.ratio(pair.ratio()) + " times the CPU, ").orElse("");
    String stopped =
        run.stopsMeasured()
            ? ", stopped for " + Numbers.plain(100 * run.stoppedShare(), 3) + " % of the time"
            : "";
    GcCase of = run.of();
    String where = GcRuns.work(of.workload()) + GcPhrases.inHeap(of.heapFactor());
    String java = runs.javas().size() > 1 ? " of " + runs.javaName(of.java()) : "";
    return cost
        + GcRuns.count(run.figures().collections(), "collection")
        + stopped
        + " ("
        + where
        + java
        + ")";
  }

  private Optional<String> otherSettings() {
    Predicate<Pair> told = pair -> isHumongous(pair.other());
    List<String> said = new ArrayList<>();
    for (Setting setting : runs.settings().subList(1, runs.settings().size())) {
      for (double heap : runs.heaps(setting)) {
        List<Pair> pairs = runs.pairs(setting, ScratchPolicy.PER_CELL, heap);
        if (!pairs.stream().allMatch(told)) {
          said.add(
              setting.name()
                  + GcPhrases.inHeap(heap)
                  + ": "
                  + GcPhrases.costs(pairs)
                  + phrases.extremes(pairs, Pair::ratio));
        }
      }
    }
    return said.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "CPU of scratch per cell over enduring scratch, with other work and sizes: "
                + String.join("; ", said)
                + ".");
  }

  private Optional<String> dead() {
    Map<String, List<GcRow>> alike = new LinkedHashMap<>();
    for (GcRow row : runs.dead()) {
      alike
          .computeIfAbsent(runs.name(row.of()) + "\n" + GcRuns.why(row), of -> new ArrayList<>())
          .add(row);
    }
    return alike.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "No figures from "
                + runs.dead().size()
                + " of "
                + GcRuns.count(runs.rows().size(), "run")
                + ": "
                + alike.values().stream().map(this::dead).collect(Collectors.joining("; "))
                + ".");
  }

  private String dead(List<GcRow> alike) {
    GcRow first = alike.get(0);
    return (alike.size() == 1 ? "" : alike.size() + "x ")
        + runs.name(first.of())
        + ", "
        + names(alike, row -> GcRuns.policy(row.of().policy()))
        + " ("
        + GcRuns.why(first)
        + ")";
  }
}
