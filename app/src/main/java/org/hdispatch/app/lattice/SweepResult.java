package org.hdispatch.app.lattice;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.hdispatch.lbm.duct.DuctFigures;
import org.hdispatch.lbm.duct.Spread;

/**
 * What a sweep has found.
 *
 * @param settings what was stepped
 * @param probeBytes over how many bytes the bandwidth was measured
 * @param points the runs that were done, in their order
 */
record SweepResult(DuctSettings settings, long probeBytes, List<Point> points) {
  /** Label of the control: one block of nodes a thread. */
  static final String CONTROL = "one block";

  /** Twice the largest cube of a sweep; 120 MB and more, in double precision. */
  static final int LEAST_STORABLE_SIDE = 100;

  /** Sums of equal flows in another order differ by rounding, and by no more. */
  private static final double SAME_FLOW = 1e-9;

  /**
   * Keeps a copy of the points, and checks that all runs of a size came to the same flow.
   *
   * @throws IllegalStateException if they did not
   */
  SweepResult {
    points = List.copyOf(points);
    for (Point each : points) {
      Point first = points.stream().filter(each::isSameFlow).findFirst().orElse(each);
      double k = each.figures().kOverW2();
      if (!(Math.abs(k / first.figures().kOverW2() - 1) <= SAME_FLOW)) {
        throw new IllegalStateException(
            "bundles and threads must not change the flow: " + first + ", " + each);
      }
    }
  }

  /**
   * One run.
   *
   * @param what which
   * @param figures what was measured
   */
  record Point(DuctSweep.Case what, DuctFigures figures) {
    int side() {
      return what.duct().side();
    }

    int threads() {
      return what.threads();
    }

    String label() {
      return what.label();
    }

    double mlups() {
      return figures.mlupsMedian();
    }

    private boolean isSameFlow(Point other) {
      return side() == other.side() && figures.lastStep() == other.figures.lastStep();
    }
  }

  /** The run of a bundle, if it was done. */
  Optional<Point> at(int side, String label, int threads) {
    return points.stream()
        .filter(p -> p.side() == side && p.threads() == threads && p.label().equals(label))
        .findFirst();
  }

  private Optional<Point> single(Point point) {
    return at(point.side(), point.label(), 1);
  }

  /** Speed over that of the same bundle on one thread. */
  OptionalDouble speedUp(Point point) {
    return of(single(point).map(one -> point.mlups() / one.mlups()));
  }

  /** Speed-up over the number of threads. */
  OptionalDouble efficiency(Point point) {
    return of(single(point).map(one -> point.mlups() / one.mlups() / point.threads()));
  }

  /** Speed-up of the bandwidth itself, by the medians over all runs. */
  OptionalDouble bandwidthSpeedUp(int threads) {
    return of(
        bandwidth(1).flatMap(one -> bandwidth(threads).map(many -> many.median() / one.median())));
  }

  /** Over the runs with so many threads, GB/s; empty if there are none. */
  Optional<Spread> bandwidth(int threads) {
    double[] medians =
        points.stream()
            .filter(p -> p.threads() == threads)
            .mapToDouble(p -> p.figures().gigabytesPerSecond().median())
            .toArray();
    return medians.length == 0 ? Optional.empty() : Optional.of(Spread.of(medians));
  }

  /**
   * The bandwidth-limited ideal, MLUPS: the threads times the speed of the same bundle on one
   * thread, or what the bandwidth beside the run lets through, whichever is less.
   */
  OptionalDouble idealMlups(Point point) {
    return of(
        single(point)
            .map(one -> Math.min(point.threads() * one.mlups(), point.figures().bandwidthMlups())));
  }

  /**
   * Speed over {@link #idealMlups}: the greater of the efficiency and the share of the bandwidth.
   * More than 1 where the populations stay in a cache.
   */
  OptionalDouble idealFraction(Point point) {
    OptionalDouble ideal = idealMlups(point);
    return ideal.isPresent()
        ? OptionalDouble.of(point.mlups() / ideal.getAsDouble())
        : OptionalDouble.empty();
  }

  private static OptionalDouble of(Optional<Double> value) {
    return value.map(OptionalDouble::of).orElse(OptionalDouble.empty());
  }

  List<Integer> sides() {
    return points.stream().map(Point::side).distinct().toList();
  }

  List<Integer> threads() {
    return points.stream().map(Point::threads).distinct().sorted().toList();
  }

  /** Bundles in the order of the sweep, the control last. */
  List<String> labels() {
    Stream<String> bundles =
        points.stream().map(Point::label).filter(each -> !each.equals(CONTROL));
    return Stream.concat(bundles, points.stream().map(Point::label)).distinct().toList();
  }

  /** The fastest bundle of a size, with the most threads. */
  Optional<Point> best(int side) {
    int most = threads().get(threads().size() - 1);
    return points.stream()
        .filter(p -> p.side() == side && p.threads() == most && !p.what().isControl())
        .max(Comparator.comparingDouble(Point::mlups));
  }

  /** The fastest bundle of the first size. */
  Optional<Point> recommended() {
    return sides().stream().flatMap(side -> best(side).stream()).findFirst();
  }

  /**
   * What is recommended, if it says anything about larger ducts: in a small one large bundles are
   * cut short, and a cache may hold it all.
   */
  Optional<Point> storable() {
    return recommended().filter(best -> best.side() >= LEAST_STORABLE_SIDE);
  }
}
