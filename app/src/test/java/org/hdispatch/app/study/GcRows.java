package org.hdispatch.app.study;

import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** Rows as a study makes them, for tests. */
public final class GcRows {
  public static final GcOrigin ORIGIN =
      new GcOrigin("Maker", "17.0.15+6", "processor of 2 GHz", 2, 8, "Linux 6, amd64", "c0de");

  private GcRows() {}

  /** A first run. */
  public static GcRow first(GcCase of, String why, Optional<GcFigures> figures) {
    return new GcRow(of, why, figures, 1, ORIGIN);
  }

  /** The same row, as if it had been made by another run of its case. */
  public static GcRow again(GcRow row, int fork) {
    return new GcRow(row.of(), row.why(), row.figures(), fork, row.origin());
  }

  /** The same row, made elsewhere. */
  public static GcRow by(GcRow row, GcOrigin origin) {
    return new GcRow(row.of(), row.why(), row.figures(), row.fork(), origin);
  }

  /** That of rows which this code makes now. */
  public static GcOrigin here(Jdk jdk) throws IOException {
    return GcOrigin.of(jdk, CodeHash.of(ChildJvm.classPath()));
  }

  public static GcCase run(Collector collector, ScratchPolicy policy, double heapFactor) {
    return new GcCase("17.0.15", collector, policy, Workload.COMPUTE, 1 << 16, heapFactor);
  }

  public static GcRow died(GcCase run, String why) {
    return first(run, why, Optional.empty());
  }

  /** A run of 100 steps and these processor times. */
  public static GcRow row(GcCase run, double workerCpuSeconds, double otherCpuSeconds) {
    GcFigures.Stops pauses = new GcFigures.Stops(2, 3.25, 2, 2);
    GcFigures.Stops stopped = new GcFigures.Stops(3, 4.5, 2.5, 2.5);
    GcFigures.Stops stalls = new GcFigures.Stops(0, 0, 0, 0);
    GcFigures.StepTimes times =
        new GcFigures.StepTimes(
            10_000, 12_000, -1, 12_000, List.of(11_000.0, 13_000.0), List.of(90L, 10L));
    return first(
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
                0.5 * otherCpuSeconds,
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
