package org.hdispatch.app.lattice;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.duct.BandwidthProbe;
import org.hdispatch.lbm.duct.Duct;
import org.hdispatch.lbm.duct.DuctFigures;
import org.hdispatch.lbm.duct.DuctRun;
import org.hdispatch.lbm.duct.Spread;
import org.hdispatch.porous.block.HeapException;

/**
 * Ducts of several sizes, each with several bundles and numbers of threads (Leonardi et al. 2011,
 * figure 4), and one block of nodes a thread as a control: what bundles cost.
 *
 * <p>All numbers of threads of a bundle are run one after the other, so that a speed-up compares
 * neighbours in time (with several rounds, runs beside like bandwidths). What does not fit into the
 * heap is left out, and said.
 */
final class DuctSweep {
  /** The sides of figure 4. */
  private static final int[] CUBES = {10, 16, 20, 25, 32, 40, 50};

  private static final String[] LONG = {
    "32,8,8", "64,16,16", "all,8,8", "all,10,10", "all,16,16", "all,20,20", "all,all,10"
  };

  private final Host host;
  private final DuctOptions options;
  private final Consumer<String> warn;
  private final int[] threads;
  private HeapException tooLarge; // the first, if any is
  private OutOfMemoryError ranOut; // the last, if any run did

  DuctSweep(Host host, DuctOptions options, int mostThreads, Consumer<String> warn) {
    this.host = host;
    this.options = options;
    this.warn = warn;
    threads = ThreadOptions.upTo(mostThreads);
  }

  /**
   * One run of the sweep.
   *
   * @param duct size and bundle
   * @param label the bundle as it was asked for
   * @param isControl whether it is one block a thread
   * @param threads workers
   */
  record Case(Duct duct, String label, boolean isControl, int threads) {
    private double work() {
      return (double) duct.nodes() / threads;
    }
  }

  /** Hears how a sweep goes on. */
  @FunctionalInterface
  interface Listener {
    /** Hears nothing. */
    Listener NONE = (one, number, count, shareDone) -> {};

    /**
     * Some steps have been done.
     *
     * @param one the run that is under way
     * @param number its number, from 1
     * @param count how many runs there are
     * @param shareDone how much of the work is done, 0 to 1
     */
    void progressed(Case one, int number, int count, double shareDone);
  }

  /**
   * Runs it.
   *
   * @throws UsageException if the options are out of their bounds
   * @throws HeapException if nothing fits into the heap
   */
  SweepResult run(Listener listener) {
    int rounds = options.rounds();
    List<Integer> sizes = options.sizes();
    for (int side : sizes) { // refused now, not after minutes
      options.run(duct(side, BundleShape.LONG_ROWS));
    }
    List<String> leftOut = new ArrayList<>();
    List<Case> fitting = new ArrayList<>();
    for (int side : sizes) {
      fitting.addAll(fitting(cases(side, leftOut), leftOut));
    }
    if (fitting.isEmpty()) {
      throw tooLarge;
    }
    leftOut.forEach(warn);
    long probeBytes =
        fitting.stream().mapToLong(each -> DuctHeap.require(host, each.duct())).min().orElseThrow();
    BandwidthProbe probe = new BandwidthProbe(probeBytes);
    List<SweepResult.Point> points = run(fitting, rounds, probe, listener);
    return new SweepResult(options.settings(), probe.bytes(), points);
  }

  /** All of a size; shapes that come to the same bundle in it count once. */
  private List<Case> cases(int side, List<String> leftOut) {
    List<Case> cases = new ArrayList<>();
    Set<BundleSize> seen = new HashSet<>();
    for (BundleShape shape : shapes()) {
      Duct duct = UsageException.orRefused(() -> duct(side, shape));
      if (seen.add(duct.bundle())) {
        for (int count : threads) {
          cases.add(new Case(duct, shape.toString(), false, count));
        }
      }
    }
    for (int count : threads) {
      BundleShape block = new BundleShape(side, side, (side + count - 1) / count);
      try {
        cases.add(new Case(duct(side, block), SweepResult.CONTROL, true, count));
      } catch (IllegalArgumentException e) {
        leftOut.add("one block a thread is left out: " + e.getMessage());
      }
    }
    return cases;
  }

  /** Those of one size that fit into the heap; what does not is said once for all threads. */
  private List<Case> fitting(List<Case> ofSize, List<String> leftOut) {
    List<Case> fitting = new ArrayList<>();
    Map<String, HeapException> bundles = new LinkedHashMap<>();
    String size = "size " + ofSize.get(0).duct().side();
    for (Case each : ofSize) {
      try {
        DuctHeap.require(host, each.duct());
        fitting.add(each);
      } catch (HeapException e) {
        bundles.putIfAbsent(each.label() + " at " + size, e);
        tooLarge = tooLarge == null ? e : tooLarge;
      }
    }
    if (fitting.isEmpty()) {
      leftOut.add(size + " is left out: " + bundles.values().iterator().next().getMessage());
    } else {
      bundles.forEach((what, e) -> leftOut.add(what + " is left out: " + e.getMessage()));
    }
    return fitting;
  }

  private List<BundleShape> shapes() {
    if (!options.bundles().isEmpty()) {
      return options.bundles().stream().distinct().toList();
    }
    List<BundleShape> shapes = new ArrayList<>();
    for (int side : CUBES) {
      shapes.add(new BundleShape(side, side, side));
    }
    for (String shape : LONG) {
      shapes.add(BundleShape.parse(shape));
    }
    return shapes;
  }

  private Duct duct(int side, BundleShape shape) {
    return options.settings().duct(side, shape);
  }

  private List<SweepResult.Point> run(
      List<Case> cases, int rounds, BandwidthProbe probe, Listener listener) {
    int count = cases.size();
    double all = rounds * cases.stream().mapToDouble(Case::work).sum();
    double done = 0;
    List<List<DuctFigures>> figures = new ArrayList<>();
    cases.forEach(each -> figures.add(new ArrayList<>()));
    for (int n = 0; n < rounds * count; n++) {
      Case one = cases.get(n % count);
      List<DuctFigures> ofCase = figures.get(n % count);
      if (n < count || !ofCase.isEmpty()) { // what did not fit the first time is left out
        int number = n + 1;
        double before = done;
        measure(
            one,
            probe,
            share ->
                listener.progressed(
                    one, number, rounds * count, (before + one.work() * share) / all),
            ofCase);
      }
      done += one.work();
    }
    List<SweepResult.Point> points = new ArrayList<>();
    for (int n = 0; n < count; n++) {
      if (!figures.get(n).isEmpty()) {
        double usual = usualBandwidth(figures, cases.get(n).threads());
        points.add(new SweepResult.Point(cases.get(n), nearest(figures.get(n), usual)));
      }
    }
    if (points.isEmpty()) {
      throw ranOut;
    }
    return points;
  }

  /** Measures one case, if it fits into the heap. */
  private void measure(
      Case one, BandwidthProbe probe, DoubleConsumer shareDone, List<DuctFigures> figures) {
    DuctRun.Listener steps =
        new DuctRun.Listener() {
          @Override
          public void progressed(long step, long lastStep) {
            shareDone.accept((double) step / lastStep);
          }
        };
    try (Dispatcher dispatcher = Dispatcher.withWorkers(one.threads())) {
      figures.add(options.run(one.duct()).measure(dispatcher, one.duct(), probe, steps));
    } catch (OutOfMemoryError e) { // the estimate knows no regions
      warn.accept(
          one.label() + " at size " + one.duct().side() + " is left out: " + e.getMessage());
      ranOut = e;
    }
  }

  /**
   * The one with the most usual bandwidth beside it: others who share the machine make it another
   * machine for a while, and speeds measured on different machines cannot be compared.
   *
   * @param usual bandwidth, GB/s
   */
  static DuctFigures nearest(List<DuctFigures> figures, double usual) {
    return Collections.min(
        figures,
        Comparator.comparingDouble(each -> Math.abs(each.gigabytesPerSecond().median() - usual)));
  }

  /** Median over all rounds of all cases with so many threads, GB/s. */
  private static double usualBandwidth(List<List<DuctFigures>> figures, int threads) {
    return Spread.of(
            figures.stream()
                .flatMap(List::stream)
                .filter(each -> each.threads() == threads)
                .mapToDouble(each -> each.gigabytesPerSecond().median())
                .toArray())
        .median();
  }
}
