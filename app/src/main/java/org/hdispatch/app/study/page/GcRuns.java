package org.hdispatch.app.study.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.IntSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcFigures;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.ScratchPolicy;
import org.hdispatch.app.study.StudyScope;
import org.hdispatch.app.study.Workload;
import org.hdispatch.app.text.Numbers;

/**
 * The rows of a study of garbage collection, put in order: what was measured in which case, and
 * what is to be compared with what.
 *
 * <p>Immutable.
 */
final class GcRuns {
  private final List<GcRow> rows;
  private final Map<GcCase, List<Run>> runs = new LinkedHashMap<>(); // by the number of the run

  /**
   * The work that runs must share to be compared.
   *
   * @param workload what is stepped
   * @param scratchBytes size of a scratch
   */
  record Setting(Workload workload, int scratchBytes) {
    static Setting of(GcCase of) {
      return new Setting(of.workload(), of.scratchBytes());
    }

    /** In words. */
    String name() {
      return work(workload) + ", scratch of " + Numbers.bytes(scratchBytes);
    }
  }

  /** What was measured in a case, or follows from it. */
  interface Measured {
    /** The case. */
    GcCase of();
  }

  /**
   * A run that was measured.
   *
   * @param of what was run
   * @param fork which run of it
   * @param figures of at least one step
   */
  record Run(GcCase of, int fork, GcFigures figures) implements Measured {
    /** Processor time of the threads that stepped, us per cell. */
    double workers() {
      return perCell(figures.workerCpuSeconds());
    }

    /** Processor time of all other threads, us per cell. */
    double others() {
      return perCell(figures.otherCpuSeconds());
    }

    /** The collector's part of that; negative if it is not known. */
    double collector() {
      return figures.collectorCpuSeconds() < 0 ? -1 : perCell(figures.collectorCpuSeconds());
    }

    /** Processor time of all threads, us per cell. */
    double cpu() {
      return workers() + others();
    }

    private double perCell(double seconds) {
      return 1e6 * seconds / figures.steps() / figures.cells();
    }

    /** Whether somebody looked for how long all threads were stopped. */
    boolean stopsMeasured() {
      return figures.stopped().count() >= 0;
    }

    /** Share of the wall time in which all threads were stopped; only if it was measured. */
    double stoppedShare() {
      return 1e-3 * figures.stopped().totalMillis() / figures.seconds();
    }

    /** Bytes that all workers allocated per step; negative if not measured. */
    double bytesPerStep() {
      return Math.max(figures.bytesPerStep(), figures.bytesPerStepInAll());
    }
  }

  /**
   * Two runs of one round that differ in who keeps the scratch.
   *
   * @param enduring with enduring scratch
   * @param other with another
   */
  record Round(Run enduring, Run other) {
    /** Processor time over that with enduring scratch. */
    double ratio() {
      return other.cpu() / enduring.cpu();
    }

    /** 90th percentile of the step time over that with enduring scratch. */
    double tailRatio() {
      return other.figures().stepTimes().p90Micros() / enduring.figures().stepTimes().p90Micros();
    }
  }

  /**
   * Two cases that differ in who keeps the scratch. What is said of them is the median over the
   * rounds in which both were measured.
   *
   * @param enduring the run that stands for enduring scratch
   * @param other the run that stands for another
   * @param rounds at least one
   */
  record Pair(Run enduring, Run other, List<Round> rounds) implements Measured {
    @Override
    public GcCase of() {
      return other.of();
    }

    private double[] sorted(ToDoubleFunction<Round> what) {
      return rounds.stream().mapToDouble(what).sorted().toArray();
    }

    private double median(ToDoubleFunction<Round> what) {
      double[] sorted = sorted(what);
      return 0.5 * (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]);
    }

    /** Processor time over that with enduring scratch. */
    double ratio() {
      return median(Round::ratio);
    }

    /** The least of these in any round. */
    double leastRatio() {
      return sorted(Round::ratio)[0];
    }

    /** The most of these in any round. */
    double mostRatio() {
      return sorted(Round::ratio)[rounds.size() - 1];
    }

    /** What the other one takes more, us of processor time per cell. */
    double extra() {
      return median(round -> round.other().cpu() - round.enduring().cpu());
    }

    /** The workers' part of that. */
    double extraOfWorkers() {
      return median(round -> round.other().workers() - round.enduring().workers());
    }

    /** Whether the operating system tells what the collector took. */
    boolean knowsCollector() {
      return rounds.stream()
          .allMatch(round -> round.other().collector() >= 0 && round.enduring().collector() >= 0);
    }

    /** The collector's part of that. */
    double extraOfCollector() {
      return median(round -> round.other().collector() - round.enduring().collector());
    }

    /** 90th percentile of the step time over that with enduring scratch. */
    double tailRatio() {
      return median(Round::tailRatio);
    }
  }

  /** Takes rows in any order. */
  GcRuns(List<GcRow> rows) {
    this.rows = List.copyOf(rows);
    for (GcRow row : rows) {
      run(row).ifPresent(run -> runs.computeIfAbsent(row.of(), of -> new ArrayList<>()).add(run));
    }
    runs.values().forEach(several -> several.sort(Comparator.comparingInt(Run::fork)));
  }

  /**
   * The run that stands for a case: of the median processor time, the lower of two in the middle.
   */
  private static Run median(List<Run> several) {
    return several.stream()
        .sorted(Comparator.comparingDouble(Run::cpu))
        .skip((several.size() - 1) / 2)
        .findFirst()
        .orElseThrow();
  }

  /** What was measured, if anything was: a row without a step says nothing. */
  static Optional<Run> run(GcRow row) {
    return row.figures()
        .filter(figures -> figures.steps() > 0 && figures.cells() > 0 && figures.seconds() > 0)
        .map(figures -> new Run(row.of(), row.fork(), figures));
  }

  /** Why a row has no figures. */
  static String why(GcRow row) {
    return row.figures().isPresent() ? "it did not finish a step" : row.why();
  }

  /** All rows, as given. */
  List<GcRow> rows() {
    return rows;
  }

  /** Rows in which nothing was measured. */
  List<GcRow> dead() {
    return rows.stream().filter(row -> run(row).isEmpty()).toList();
  }

  /** What was measured, a run for each case. */
  List<Run> runs() {
    return runs.values().stream().map(GcRuns::median).toList();
  }

  /** All that was measured. */
  List<Run> singles() {
    return runs.values().stream().flatMap(List::stream).toList();
  }

  /** How often cases were run: fewest and most runs of any. */
  IntSummaryStatistics repeats() {
    return rows.stream()
        .collect(Collectors.groupingBy(GcRow::of, Collectors.counting()))
        .values()
        .stream()
        .mapToInt(Math::toIntExact)
        .summaryStatistics();
  }

  /** How often cases were run, in words. */
  String repeatsInWords() {
    IntSummaryStatistics repeats = repeats();
    return repeats.getMin() == repeats.getMax()
        ? Integer.toString(repeats.getMax())
        : repeats.getMin() + " to " + repeats.getMax();
  }

  /** What was measured in this case, if anything: the run that stands for it. */
  Optional<Run> run(GcCase of) {
    return Optional.ofNullable(runs.get(of)).map(GcRuns::median);
  }

  /** Versions of the JVM, in the order of the rows. */
  List<String> javas() {
    return rows.stream().map(row -> row.of().java()).distinct().toList();
  }

  /** Collectors, in their order. */
  List<Collector> collectors() {
    return rows.stream().map(row -> row.of().collector()).distinct().sorted().toList();
  }

  /** Settings, the one with the most comparisons first; that is the one to be looked at. */
  List<Setting> settings() {
    return rows.stream()
        .map(row -> Setting.of(row.of()))
        .distinct()
        .sorted(
            Comparator.comparing((Setting s) -> !isStandard(s))
                .thenComparingInt(s -> -pairs(s, ScratchPolicy.PER_CELL).size())
                .thenComparingInt(s -> -(int) cases(s).count())
                .thenComparing(Setting::workload)
                .thenComparingInt(Setting::scratchBytes))
        .toList();
  }

  /** Whether it is the one that every study has, and there is something to compare. */
  private boolean isStandard(Setting setting) {
    return setting.workload() == Workload.LBM
        && setting.scratchBytes() == StudyScope.STANDARD
        && !pairs(setting, ScratchPolicy.PER_CELL).isEmpty();
  }

  /**
   * How much the same work differs: the largest ratio of two cases with enduring scratch on one JVM
   * and collector. Where nothing is collected, the size of the heap is no reason to differ. 1 if
   * there are no two such cases.
   */
  double noise(Setting setting) {
    double noise = 1;
    List<Run> enduring = runs(setting, ScratchPolicy.ENDURING);
    for (Run a : enduring) {
      for (Run b : enduring) {
        if (a.of().java().equals(b.of().java())
            && a.of().collector() == b.of().collector()
            && a.figures().collections() + b.figures().collections() == 0) {
          noise = Math.max(noise, a.cpu() / b.cpu());
        }
      }
    }
    return noise;
  }

  private Stream<GcCase> cases(Setting setting) {
    return rows.stream().map(GcRow::of).filter(of -> Setting.of(of).equals(setting)).distinct();
  }

  /** Cases of a setting, by collector and policy, in one JVM and size of heap. */
  List<GcCase> cases(Setting setting, String java, double heap) {
    return cases(setting)
        .filter(of -> of.java().equals(java) && of.heapFactor() == heap)
        .sorted(Comparator.comparing(GcCase::collector).thenComparing(GcCase::policy))
        .toList();
  }

  /** Sizes of the heap in a setting, in multiples of the smallest that runs, the largest first. */
  List<Double> heaps(Setting setting) {
    return cases(setting)
        .map(GcCase::heapFactor)
        .distinct()
        .sorted(Comparator.reverseOrder())
        .toList();
  }

  /** Runs of a policy in a setting, in the order of the rows. */
  List<Run> runs(Setting setting, ScratchPolicy policy) {
    return runs().stream()
        .filter(run -> run.of().policy() == policy && Setting.of(run.of()).equals(setting))
        .toList();
  }

  /** The same case with enduring scratch. */
  private static GcCase enduring(GcCase of) {
    return new GcCase(
        of.java(),
        of.collector(),
        ScratchPolicy.ENDURING,
        of.workload(),
        of.scratchBytes(),
        of.heapFactor());
  }

  /** The run of the same case with enduring scratch in the same round. */
  Optional<Round> round(Run run) {
    return runs.getOrDefault(enduring(run.of()), List.of()).stream()
        .filter(base -> base.fork() == run.fork() && base.cpu() > 0)
        .map(base -> new Round(base, run))
        .findFirst();
  }

  /** A case beside the same with enduring scratch. */
  Optional<Pair> pair(Run run) {
    List<Round> rounds = runs.get(run.of()).stream().flatMap(each -> round(each).stream()).toList();
    return rounds.isEmpty()
        ? Optional.empty()
        : run(enduring(run.of())).map(base -> new Pair(base, run, rounds));
  }

  /** Runs of a policy in a setting beside enduring ones, in the order of the rows. */
  List<Pair> pairs(Setting setting, ScratchPolicy policy) {
    return runs(setting, policy).stream().flatMap(run -> pair(run).stream()).toList();
  }

  /** Those with one size of the heap. */
  List<Pair> pairs(Setting setting, ScratchPolicy policy, double heap) {
    return pairs(setting, policy).stream().filter(pair -> pair.of().heapFactor() == heap).toList();
  }

  /** A JVM by the first number of its version, or by all of it where that is not enough. */
  String javaName(String version) {
    long alike = javas().stream().filter(java -> feature(java).equals(feature(version))).count();
    return "Java " + (alike > 1 ? version : feature(version));
  }

  private static String feature(String version) {
    return version.split("[.+-]", 2)[0];
  }

  /** A collector, and the JVM it is of if there are several. */
  String name(GcCase of) {
    String collector = of.collector().title();
    return javas().size() > 1 ? collector + " on " + javaName(of.java()) : collector;
  }

  /** Who keeps scratch, in few words. */
  static String policy(ScratchPolicy policy) {
    return switch (policy) {
      case ENDURING -> "enduring";
      case PER_STEP -> "per step";
      case PER_CELL -> "per cell";
      case THREAD_LOCAL_POOL -> "ThreadLocal pool";
      case THREAD_LOCAL_VIRTUAL -> "virtual threads";
      case OBJECT_POOL -> "object pool";
    };
  }

  /** What is stepped, in words. */
  static String work(Workload workload) {
    return switch (workload) {
      case LBM -> "LBM step";
      case SPH -> "SPH step";
      case BANDWIDTH -> "sweep bound by memory";
      case COMPUTE -> "sweep bound by computing";
    };
  }

  /** So many of something. */
  static String count(long count, String what) {
    return count + " " + what + (count == 1 ? "" : "s");
  }

  /** A size of the heap. */
  static String heap(double factor) {
    return Numbers.plain(factor, 3) + "x";
  }
}
