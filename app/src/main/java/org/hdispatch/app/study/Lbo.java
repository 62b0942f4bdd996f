package org.hdispatch.app.study;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * The cost of every run over a distilled baseline (LBO: lower-bound overhead; Cai, Blackburn, Bond
 * and Maas, "Distilling the Real Cost of Production Garbage Collectors", ISPASS 2022).
 *
 * <p>Nobody can run a program without any memory management, but no collector costs less than
 * nothing: so the least processor time that any run spent apart from its collector is an upper
 * bound of what the work itself takes, and the cost of a run over it a lower bound of what its
 * memory management costs. The baseline is the least over all collectors, policies and heaps of
 * (processor time per step - that of the collector) among the runs of one JVM, workload and size of
 * scratch.
 *
 * <p>Immutable.
 */
public final class Lbo {
  private final Map<Group, Double> baselines; // s of processor time per step

  private Lbo(Map<Group, Double> baselines) {
    this.baselines = Map.copyOf(baselines);
  }

  /** Runs that did the same work on the same JVM. */
  private record Group(String java, Workload workload, int scratchBytes) {
    static Group of(GcCase run) {
      return new Group(run.java(), run.workload(), run.scratchBytes());
    }
  }

  /**
   * The baselines of these runs.
   *
   * @param rows of a study; those without figures are passed over
   */
  public static Lbo of(List<GcRow> rows) {
    Map<Group, Double> baselines = new HashMap<>();
    for (GcRow row : rows) {
      if (row.figures().isPresent()) {
        GcFigures figures = row.figures().get();
        double distilled = figures.workerCpuSeconds() / figures.steps();
        baselines.merge(Group.of(row.of()), distilled, Math::min);
      }
    }
    return new Lbo(baselines);
  }

  /**
   * Processor time of the work itself, as far as any run can tell.
   *
   * @param run any run of the same JVM, workload and size of scratch
   * @return seconds per step; empty if there are figures of no such run
   */
  public OptionalDouble baselineSeconds(GcCase run) {
    Double baseline = baselines.get(Group.of(run));
    return baseline == null ? OptionalDouble.empty() : OptionalDouble.of(baseline);
  }

  /**
   * Processor time of all threads per step, the collector's with it, over the baseline.
   *
   * @param row one of the rows that the baselines come from
   * @return at least 1; empty if the row has no figures, or is not among those
   */
  public OptionalDouble cost(GcRow row) {
    return row.figures().isEmpty() ? OptionalDouble.empty() : cost(row.of(), row.figures().get());
  }

  /** The same of figures, as in a row. */
  public OptionalDouble cost(GcCase run, GcFigures figures) {
    OptionalDouble baseline = baselineSeconds(run);
    if (baseline.isEmpty()) {
      return OptionalDouble.empty();
    }
    double all = figures.workerCpuSeconds() + figures.otherCpuSeconds();
    return OptionalDouble.of(all / figures.steps() / baseline.getAsDouble());
  }
}
