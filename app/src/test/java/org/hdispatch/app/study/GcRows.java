package org.hdispatch.app.study;

import java.util.List;
import java.util.Optional;

/** Rows as a study makes them, for tests. */
public final class GcRows {
  private GcRows() {}

  public static GcCase run(Collector collector, ScratchPolicy policy, double heapFactor) {
    return new GcCase("17.0.15", collector, policy, Workload.COMPUTE, 1 << 16, heapFactor);
  }

  public static GcRow died(GcCase run, String why) {
    return new GcRow(run, why, Optional.empty());
  }

  /** A run of 100 steps and these processor times. */
  public static GcRow row(GcCase run, double workerCpuSeconds, double otherCpuSeconds) {
    GcFigures.Stops pauses = new GcFigures.Stops(2, 3.25, 2, 2);
    GcFigures.Stops stopped = new GcFigures.Stops(3, 4.5, 2.5, 2.5);
    GcFigures.Stops stalls = new GcFigures.Stops(0, 0, 0, 0);
    GcFigures.StepTimes times =
        new GcFigures.StepTimes(
            10_000, 12_000, -1, 12_000, List.of(11_000.0, 13_000.0), List.of(90L, 10L));
    return new GcRow(
        run,
        "",
        Optional.of(
            new GcFigures(
                96L << 20,
                80L << 20,
                2,
                343,
                100,
                1.0,
                workerCpuSeconds,
                otherCpuSeconds,
                2,
                pauses,
                stopped,
                0.5,
                stalls,
                times,
                11_239_424,
                22_478_848,
                List.of(
                    new GcFigures.Pause(0.25, 1.25, "GC Pause"),
                    new GcFigures.Pause(0.5, 2, "GC Pause")))));
  }
}
