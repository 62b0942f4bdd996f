package org.hdispatch.app.gc;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.Jdk;
import org.hdispatch.app.study.SoakJob;
import org.hdispatch.app.study.Workload;
import org.hdispatch.dispatch.ScratchLifetime;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;

/** What is soaked, and in which JVMs. */
final class SoakOptions {
  private static final long LBM_STEPS = 1_000_000;
  private static final long SPH_STEPS = 100_000;
  private static final long MOST = 1_000_000_000;

  /** Share of the steps that is warm-up if nothing is said. */
  private static final int WARM_UP_SHARE = 10;

  /** Loops are compiled and most cells have grown after so many. */
  private static final long LEAST_WARM_UP = 2000;

  /** Which methods. */
  enum Methods {
    LBM(Workload.LBM),
    SPH(Workload.SPH),
    ALL(Workload.LBM, Workload.SPH);

    private final List<Workload> workloads;

    Methods(Workload... workloads) {
      this.workloads = List.of(workloads);
    }
  }

  @Option(
      names = "--method",
      paramLabel = "METHOD",
      defaultValue = "all",
      completionCandidates = MethodWords.class,
      description = "What is stepped: ${COMPLETION-CANDIDATES}.")
  private Methods methods;

  @Option(
      names = "--steps",
      paramLabel = "N",
      description = "Steps after warm-up. Default: 1000000 of lbm, 100000 of sph.")
  private Long steps;

  @Option(
      names = "--warm-up",
      paramLabel = "N",
      description = "Steps before those. Default: a tenth of them, and 2000 at least.")
  private Long warmUp;

  @Option(
      names = "--collectors",
      paramLabel = "NAME",
      split = ",",
      hideParamSyntax = true,
      converter = CollectorConverter.class,
      completionCandidates = CollectorWords.class,
      description = "Such as epsilon,g1: ${COMPLETION-CANDIDATES}. Default: all that a JDK has.")
  private List<Collector> collectors;

  @Option(
      names = "--jdk",
      paramLabel = "PATH",
      arity = "1..*",
      hideParamSyntax = true,
      description = "Homes of Java 17 or newer whose JVMs are started. Default: this one.")
  private List<Path> homes;

  @Option(
      names = "--scratch",
      paramLabel = "LIFE",
      defaultValue = "enduring",
      converter = LifetimeConverter.class,
      completionCandidates = Choices.OfLifetimes.class,
      description =
          "How long scratch lives: ${COMPLETION-CANDIDATES}. Anything but enduring shows that the"
              + " soak can fail.")
  private ScratchLifetime lifetime;

  /** Words for what is soaked. */
  static final class MethodWords extends Choices {
    MethodWords() {
      super(Methods.values());
    }
  }

  /** Words for collectors. */
  static final class CollectorWords extends Choices {
    CollectorWords() {
      super(Collector.values());
    }
  }

  /** Reads a collector: picocli knows no hyphens in enumerations. */
  static final class CollectorConverter implements ITypeConverter<Collector> {
    @Override
    public Collector convert(String text) {
      return Choices.value(Collector.values(), text);
    }
  }

  /** Reads a lifetime. */
  static final class LifetimeConverter implements ITypeConverter<ScratchLifetime> {
    @Override
    public ScratchLifetime convert(String text) {
      return Choices.value(ScratchLifetime.values(), text);
    }
  }

  /**
   * What is run in each JVM.
   *
   * @throws UsageException if the steps are out of their bounds
   */
  List<SoakJob> jobs(int threads) {
    List<SoakJob> jobs = new ArrayList<>();
    for (Workload each : methods.workloads) {
      long usual = each == Workload.LBM ? LBM_STEPS : SPH_STEPS;
      long count = checked("steps", SoakJob.LEAST_STEPS, steps == null ? usual : steps);
      long before =
          warmUp == null
              ? Math.max(LEAST_WARM_UP, count / WARM_UP_SHARE)
              : checked("warm-up steps", 1, warmUp);
      jobs.add(new SoakJob(each, before, count, threads, lifetime));
    }
    return jobs;
  }

  private static long checked(String what, long least, long count) {
    if (count < least || count > MOST) {
      throw new UsageException(what + " must number " + least + " to " + MOST + ": steps=" + count);
    }
    return count;
  }

  List<Collector> collectors() {
    return namesCollectors()
        ? collectors.stream().distinct().toList()
        : List.of(Collector.values());
  }

  boolean namesCollectors() {
    return collectors != null;
  }

  /**
   * Whose JVMs are started.
   *
   * @throws UsageException if one is none
   */
  List<Jdk> jdks() {
    if (homes == null) {
      return List.of(Jdk.running());
    }
    List<Jdk> jdks = new ArrayList<>();
    for (Path home : homes) {
      jdks.add(
          Jdk.at(home)
              .orElseThrow(
                  () -> new UsageException("--jdk must be a home of Java 17 or newer: " + home)));
    }
    return jdks;
  }
}
