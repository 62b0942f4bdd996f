package org.hdispatch.app.study;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.LoopStats;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.lbm.duct.Duct;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SumForm;
import org.hdispatch.sph.cases.PeriodicShear;

/**
 * The program of the JVMs that {@link Soak} starts: steps, and prints lines {@code key=value}.
 *
 * <p>It has no command line of its own kind and no Flight Recorder, for both leave garbage, and
 * under Epsilon all of it stays.
 */
final class SoakChild {
  /** Told instead of the lifetime of scratch: do not step, but say what the set-up takes. */
  static final String LIVE_SET = "LIVE_SET";

  /** Parts of a run whose bytes are counted apart. */
  static final int PARTS = SoakJob.LEAST_STEPS;

  private static final int DUCT_SIDE = 16;
  private static final int BUNDLE = 8;
  private static final int BOX_EDGE = 10;
  private static final double SUPPORT = 3;

  private SoakChild() {}

  /** What is stepped, and what to say of it in the end. */
  private record Flow(Scheme<?, ?> scheme, Supplier<String> result) {
    static Flow of(Workload workload) {
      return workload == Workload.LBM ? duct() : box();
    }

    private static Flow duct() {
      Duct duct =
          new Duct(
              DUCT_SIDE,
              VelocitySet.D3Q19,
              new BundleSize(BUNDLE, BUNDLE, BUNDLE),
              Streaming.IN_PLACE,
              Storage.DOUBLE,
              KernelForm.SCALAR);
      LbmScheme scheme = duct.scheme();
      return new Flow(scheme, () -> String.format(Locale.ROOT, "k/W2 %.4f", duct.kOverW2(scheme)));
    }

    private static Flow box() {
      PeriodicShear shear = new PeriodicShear(BOX_EDGE, SUPPORT);
      SphScheme scheme = shear.driven().form(SumForm.SCALAR).build(shear.particles());
      return new Flow(scheme, () -> "neighbours searched " + scheme.rebuilds() + " times");
    }
  }

  /**
   * Runs a {@link SoakJob}, or measures its live set.
   *
   * @param args those of the job, and {@link #LIVE_SET} if only that is wanted
   */
  public static void main(String[] args) {
    List<String> words = Arrays.asList(args);
    SoakJob job = SoakJob.of(words);
    print("java", System.getProperty("java.version"));
    try (Dispatcher dispatcher = Dispatcher.withWorkers(job.threads())) {
      Flow flow = Flow.of(job.workload());
      TimeLoop loop = dispatcher.loop(flow.scheme(), job.lifetime());
      if (words.contains(LIVE_SET)) {
        print("allocated", bytesInUse());
        System.gc();
        print("live", bytesInUse());
        print("cells", flow.scheme().cells().size()); // and keeps them until here
      } else {
        soak(loop, job);
        print("result", flow.result().get());
      }
    }
  }

  private static void soak(TimeLoop loop, SoakJob job) {
    collections(); // the first reading makes what later ones use
    loop.run(job.warmUpSteps());
    System.gc(); // so that no concurrent collection of the set-up's garbage is still under way
    long collectionsBefore = collections();
    long[] bytes = new long[PARTS];
    long from = System.nanoTime();
    for (int part = 0; part < PARTS; part++) {
      loop.resetStats();
      loop.run(job.steps() * (part + 1) / PARTS - job.steps() * part / PARTS);
      bytes[part] = bytes(loop.stats());
    }
    long to = System.nanoTime();
    print("collections", collections() - collectionsBefore);
    print("from", from);
    print("to", to);
    print("bytes", Arrays.stream(bytes).anyMatch(b -> b < 0) ? -1 : Arrays.stream(bytes).sum());
    print("parts", Arrays.stream(bytes).filter(b -> b == 0).count());
  }

  private static long bytesInUse() {
    return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
  }

  private static long bytes(LoopStats stats) {
    return stats.bytesPerStep() == LoopStats.NOT_MEASURED
        ? LoopStats.NOT_MEASURED
        : stats.workers().stream().mapToLong(LoopStats.WorkerStats::allocatedBytes).sum();
  }

  private static long collections() {
    long count = 0;
    for (GarbageCollectorMXBean bean : ManagementFactory.getGarbageCollectorMXBeans()) {
      if (!bean.getName().endsWith("Pauses")) { // ZGC and Shenandoah: those of the same cycles
        count += Math.max(0, bean.getCollectionCount());
      }
    }
    return count;
  }

  private static void print(String key, Object value) {
    System.out.println(key + "=" + value);
  }
}
