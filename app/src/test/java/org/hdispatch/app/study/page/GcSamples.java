package org.hdispatch.app.study.page;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcFigures;
import org.hdispatch.app.study.GcFigures.Pause;
import org.hdispatch.app.study.GcFigures.StepTimes;
import org.hdispatch.app.study.GcFigures.Stops;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.GcRows;
import org.hdispatch.app.study.ScratchPolicy;
import org.hdispatch.app.study.Workload;

/** Made-up rows of a study of garbage collection, of the size of those once measured. */
final class GcSamples {
  static final String OLD = "17.0.15";
  static final String NEW = "25.0.3";
  static final int SCRATCH = 64 << 10;
  static final int CELLS = 1000;
  private static final double SECONDS = 1.6;
  private static final Stops NONE = new Stops(0, 0, 0, 0);

  private GcSamples() {}

  static GcCase of(String java, Collector collector, ScratchPolicy policy, double heap) {
    return new GcCase(java, collector, policy, Workload.COMPUTE, SCRATCH, heap);
  }

  static GcCase with(GcCase of, Workload workload, int scratchBytes) {
    return new GcCase(
        of.java(), of.collector(), of.policy(), workload, scratchBytes, of.heapFactor());
  }

  static GcRow dead(GcCase of, String why) {
    return GcRows.first(of, why, Optional.empty());
  }

  /** A run that never collects. */
  static GcRow still(GcCase of, double workers, double others, double bytes) {
    return collecting(of, workers, others, 0, NONE, NONE, NONE, bytes);
  }

  /**
   * A run that collects.
   *
   * @param workers their processor time, us per cell
   * @param others that of other threads, us per cell
   * @param bytes per step of all workers
   */
  static GcRow collecting(
      GcCase of,
      double workers,
      double others,
      long collections,
      Stops pauses,
      Stops stopped,
      Stops stalls,
      double bytes) {
    long steps = Math.round(2 * SECONDS / (1e-6 * (workers + others) * CELLS));
    double micros = 1e6 * SECONDS / steps;
    boolean calm = collections == 0;
    return GcRows.first(
        of,
        "",
        Optional.of(
            new GcFigures(
                Math.round(of.heapFactor() * (66L << 20)),
                calm ? 68L << 20 : Math.round(0.9 * of.heapFactor() * (66L << 20)),
                2,
                CELLS,
                steps,
                SECONDS,
                1e-6 * workers * CELLS * steps,
                1e-6 * others * CELLS * steps,
                0.75e-6 * others * CELLS * steps,
                collections,
                pauses,
                stopped,
                0.1 * stopped.totalMillis(),
                stalls,
                times(micros, calm ? 1.1 : 2, steps),
                bytes < 0 ? -1 : Math.ceil(bytes / 2),
                bytes,
                timeline(pauses))));
  }

  /** Steps in classes of a quarter of an octave, most at the median, fewer and fewer above. */
  private static StepTimes times(double median, double tail, long steps) {
    List<Double> edges = new ArrayList<>();
    List<Long> counts = new ArrayList<>();
    long left = steps;
    for (int n = -1; left > 0; n++) {
      edges.add(median * Math.pow(2, (n + 0.5) / 4));
      long share = n == -1 ? left / 20 : (long) Math.ceil(left * (tail > 1.5 ? 0.6 : 0.9));
      counts.add(share);
      left -= share;
    }
    return new StepTimes(
        median,
        steps < 100 ? -1 : tail * median,
        steps < 1000 ? -1 : 1.3 * tail * median,
        1.5 * tail * median,
        edges,
        counts);
  }

  private static List<Pause> timeline(Stops pauses) {
    Random random = new Random(7);
    List<Pause> all = new ArrayList<>();
    double mean = pauses.totalMillis() / Math.max(1, pauses.count());
    for (int n = 0; n < pauses.count(); n++) {
      double millis = n == 0 ? pauses.maxMillis() : mean * (0.4 + random.nextDouble());
      double at = SECONDS * (n + random.nextDouble()) / pauses.count();
      all.add(new Pause(at, millis, "GC Pause"));
    }
    return all;
  }

  static Stops stops(long count, double total, double max) {
    return new Stops(count, total, 0.9 * max, max);
  }

  /** Enduring, per step and per cell, in a heap of 6x and of 2x. */
  private static void one(
      List<GcRow> rows,
      String java,
      Collector collector,
      double base,
      double[] roomy,
      double[] tight) {
    for (double heap : new double[] {6, 2}) {
      rows.add(still(of(java, collector, ScratchPolicy.ENDURING, heap), base, 0.2, 0));
      rows.add(still(of(java, collector, ScratchPolicy.PER_STEP, heap), 1.02 * base, 0.4, 131_072));
      GcCase cell = of(java, collector, ScratchPolicy.PER_CELL, heap);
      double[] f = heap == 6 ? roomy : tight;
      rows.add(
          collecting(
              cell,
              f[0],
              f[1],
              (long) f[2],
              stops((long) f[2], f[3], f[4]),
              stops((long) f[2] + 2, f[5], 1.3 * f[4]),
              collector == Collector.ZGC ? stops((long) f[6], 6 * f[6], 20) : NONE,
              65_552_000));
    }
  }

  /**
   * A study on two JVMs with all collectors, Epsilon's runs per cell out of memory, and some other
   * ways of keeping scratch with G1.
   */
  static List<GcRow> study() {
    List<GcRow> rows = new ArrayList<>();
    // workers, others, collections, pauses in all and longest, stopped, stalls
    one(
        rows,
        OLD,
        Collector.SERIAL,
        28.1,
        f(41.3, 1.3, 21, 30, 2, 74, 0),
        f(43, 4, 50, 140, 30, 160, 0));
    one(
        rows,
        OLD,
        Collector.PARALLEL,
        27,
        f(39.5, 2.2, 25, 59, 3, 118, 0),
        f(40, 30, 40, 600, 30, 690, 0));
    one(
        rows,
        OLD,
        Collector.G1,
        30.1,
        f(37.9, 1.2, 11, 42, 6, 48, 0),
        f(41, 17, 70, 98, 9, 330, 0));
    one(
        rows,
        OLD,
        Collector.ZGC,
        28,
        f(39.9, 5.5, 45, 0.6, 0.05, 120, 12),
        f(40, 9, 90, 3, 0.06, 300, 80));
    one(
        rows,
        OLD,
        Collector.SHENANDOAH,
        29,
        f(39.5, 4.3, 64, 5.6, 0.9, 27, 0),
        f(42, 15, 200, 30, 3, 120, 0));
    one(
        rows,
        NEW,
        Collector.SERIAL,
        26.3,
        f(34.1, 0.5, 29, 15, 0.8, 18, 0),
        f(37.6, 3.2, 68, 114, 34, 150, 0));
    one(
        rows,
        NEW,
        Collector.PARALLEL,
        26.8,
        f(34, 0.7, 28, 26, 1.7, 32, 0),
        f(38.6, 32.4, 41, 642, 32, 708, 0));
    one(
        rows,
        NEW,
        Collector.G1,
        27.6,
        f(37, 1.7, 11, 22, 5.6, 55, 0),
        f(41.5, 18.2, 74, 99, 9.4, 343, 0));
    one(
        rows,
        NEW,
        Collector.ZGC,
        27,
        f(39.4, 2.3, 62, 1.2, 0.06, 187, 21),
        f(38.4, 9.1, 275, 3.5, 0.06, 354, 93));
    one(
        rows,
        NEW,
        Collector.SHENANDOAH,
        28.4,
        f(41.6, 7.1, 15, 84, 43, 138, 0),
        f(43, 20, 300, 120, 20, 250, 0));
    one(
        rows,
        NEW,
        Collector.SHENANDOAH_GENERATIONAL,
        28.6,
        f(41.8, 3.4, 10, 62, 29, 63, 0),
        f(40.9, 16, 646, 39, 2.4, 189, 0));
    for (String java : new String[] {OLD, NEW}) {
      for (double heap : new double[] {6, 2}) {
        rows.add(still(of(java, Collector.EPSILON, ScratchPolicy.ENDURING, heap), 26.4, 0.1, 0));
        rows.add(
            dead(
                of(java, Collector.EPSILON, ScratchPolicy.PER_CELL, heap),
                "out of memory: Java heap space"));
      }
    }
    rows.add(still(of(NEW, Collector.G1, ScratchPolicy.THREAD_LOCAL_POOL, 6), 27.3, 0.3, 56_000));
    rows.add(still(of(NEW, Collector.G1, ScratchPolicy.OBJECT_POOL, 6), 27.1, 0.3, 24_000));
    rows.add(
        collecting(
            of(NEW, Collector.G1, ScratchPolicy.THREAD_LOCAL_VIRTUAL, 6),
            37.5,
            2.7,
            13,
            stops(13, 43, 8.1),
            stops(15, 50, 9),
            NONE,
            66e6));
    GcCase large =
        with(of(NEW, Collector.G1, ScratchPolicy.PER_CELL, 6), Workload.COMPUTE, 1 << 20);
    rows.add(
        still(
            with(of(NEW, Collector.G1, ScratchPolicy.ENDURING, 6), Workload.COMPUTE, 1 << 20),
            328,
            0.5,
            0));
    rows.add(
        collecting(large, 479, 83, 130, stops(130, 220, 9), stops(133, 254, 10), NONE, 1.05e9));
    return rows;
  }

  private static double[] f(double... figures) {
    return figures;
  }
}
