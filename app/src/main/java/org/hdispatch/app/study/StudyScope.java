package org.hdispatch.app.study;

import java.util.ArrayList;
import java.util.List;

/** Which cases a study has. */
public enum StudyScope {
  /** Two policies, with all collectors and two heaps. */
  QUICK,
  /** Three policies, and what else the verdict needs. */
  USUAL,
  /** Everything. */
  FULL;

  /** The size of scratch that most runs have. */
  public static final int STANDARD = 64 << 10;

  private static final int SMALL = 4 << 10;
  private static final int LARGE = 1 << 20;

  /** Of the heaps, in multiples of the smallest. */
  private static final List<Double> FACTORS = List.of(1.3, 2.0, 6.0);

  private static final double ROOMY = 6;
  private static final double TIGHT = 2;
  private static final int FIRST_WITH_VIRTUAL_THREADS = 21;

  /**
   * The cases, in the order in which they are run: those that are compared lie next to each other
   * in time.
   */
  public List<GcCase> cases(List<Jdk> jdks) {
    List<GcCase> cases = new ArrayList<>();
    for (Jdk jdk : jdks) {
      for (Workload workload : Workload.values()) {
        for (int scratch : new int[] {STANDARD, SMALL, LARGE}) {
          for (Collector collector : Collector.values()) {
            for (double factor : FACTORS) {
              for (ScratchPolicy policy : ScratchPolicy.values()) {
                GcCase each =
                    new GcCase(jdk.version(), collector, policy, workload, scratch, factor);
                if (has(each, jdk)) {
                  cases.add(each);
                }
              }
            }
          }
        }
      }
    }
    return List.copyOf(cases);
  }

  private boolean has(GcCase run, Jdk jdk) {
    if (run.policy() == ScratchPolicy.THREAD_LOCAL_VIRTUAL
        && jdk.feature() < FIRST_WITH_VIRTUAL_THREADS) {
      return false;
    }
    if (run.collector() == Collector.EPSILON && run.heapFactor() < ROOMY) {
      return false; // what the set-up leaves behind stays
    }
    boolean method = run.workload() == Workload.LBM || run.workload() == Workload.SPH;
    if (method && run.scratchBytes() == SMALL) {
      return false; // their own scratch takes more
    }
    return this == FULL
        || isFrame(run) && (this == USUAL || run.policy() != ScratchPolicy.PER_STEP)
        || this == USUAL && isCorner(run);
  }

  /** The method itself, with every collector. */
  private static boolean isFrame(GcCase run) {
    return run.workload() == Workload.LBM
        && run.scratchBytes() == STANDARD
        && run.heapFactor() >= TIGHT
        && run.policy().compareTo(ScratchPolicy.PER_CELL) <= 0;
  }

  /** Other policies, other sizes of scratch, other workloads: with room, and mostly with G1. */
  private static boolean isCorner(GcCase run) {
    boolean g1 = run.collector() == Collector.G1;
    if (run.heapFactor() != ROOMY) {
      return false;
    }
    if (run.workload() == Workload.LBM) {
      return g1 && run.scratchBytes() == STANDARD;
    }
    boolean twoPolicies =
        run.policy() == ScratchPolicy.ENDURING || run.policy() == ScratchPolicy.PER_CELL;
    return twoPolicies
        && switch (run.workload()) {
          case COMPUTE -> g1;
          case BANDWIDTH ->
              (g1 || run.collector() == Collector.ZGC) && run.scratchBytes() == STANDARD;
          default -> g1 && run.scratchBytes() == STANDARD;
        };
  }
}
