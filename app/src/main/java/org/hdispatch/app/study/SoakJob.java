package org.hdispatch.app.study;

import java.util.List;
import org.hdispatch.dispatch.ScratchLifetime;

/**
 * What a JVM of the soak steps.
 *
 * @param workload {@link Workload#LBM} or {@link Workload#SPH}
 * @param warmUpSteps steps before the first that counts
 * @param steps steps that count
 * @param threads workers
 * @param lifetime of scratch
 */
public record SoakJob(
    Workload workload, long warmUpSteps, long steps, int threads, ScratchLifetime lifetime) {

  /** Least steps that count: one for each part of a run. */
  public static final int LEAST_STEPS = 100;

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if there is too little to step
   */
  public SoakJob {
    if (workload != Workload.LBM && workload != Workload.SPH) {
      throw new IllegalArgumentException("soak must be of LBM or SPH: workload=" + workload);
    }
    if (steps < LEAST_STEPS) {
      throw new IllegalArgumentException(
          "steps must number at least " + LEAST_STEPS + ": steps=" + steps);
    }
    if (warmUpSteps < 1) {
      throw new IllegalArgumentException(
          "warm-up steps must number at least 1: steps=" + warmUpSteps);
    }
  }

  List<String> toArgs() {
    return List.of(
        workload.name(),
        Long.toString(warmUpSteps),
        Long.toString(steps),
        Integer.toString(threads),
        lifetime.name());
  }

  static SoakJob of(List<String> args) {
    return new SoakJob(
        Workload.valueOf(args.get(0)),
        Long.parseLong(args.get(1)),
        Long.parseLong(args.get(2)),
        Integer.parseInt(args.get(3)),
        ScratchLifetime.valueOf(args.get(4)));
  }
}
