package org.hdispatch.app.particles;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.sph.SearchMode;
import org.hdispatch.sph.SumForm;
import org.hdispatch.sph.cases.SphFigures;

/**
 * What a study of searches has found.
 *
 * @param name of what was stepped
 * @param form of the sums
 * @param points the runs that were done, in their order
 */
record SearchResult(String name, SumForm form, List<Point> points) {
  /** Keeps a copy of the points. */
  SearchResult {
    points = List.copyOf(points);
  }

  /**
   * One run, made in several rounds.
   *
   * @param mode when neighbours are searched for
   * @param threads workers
   * @param wantedEdge edge of a cell that was asked for, in distances of particles
   * @param edge what fitted the box
   * @param rounds what was measured, slowest round first
   */
  record Point(
      SearchMode mode, int threads, double wantedEdge, double edge, List<SphFigures> rounds) {
    /** Puts the rounds in order. */
    Point {
      List<SphFigures> sorted = new ArrayList<>(rounds);
      sorted.sort(Comparator.comparingDouble(SphFigures::particleStepsPerSecond));
      rounds = List.copyOf(sorted);
    }

    /** The round of median speed; the slower of two in the middle. */
    SphFigures figures() {
      return rounds.get((rounds.size() - 1) / 2);
    }

    /** Its speed, steps of a fluid particle per second. */
    double speed() {
      return figures().particleStepsPerSecond();
    }
  }

  /** A run, if it was done. */
  Optional<Point> at(SearchMode mode, int threads, double wantedEdge) {
    return points.stream()
        .filter(p -> p.mode() == mode && p.threads() == threads && p.wantedEdge() == wantedEdge)
        .findFirst();
  }

  /** Speed over that of the same mode and edge on one thread. */
  OptionalDouble speedUp(Point point) {
    Optional<Point> one = at(point.mode(), 1, point.wantedEdge());
    return one.isPresent()
        ? OptionalDouble.of(point.speed() / one.get().speed())
        : OptionalDouble.empty();
  }

  /** Speed-up over the number of threads. */
  OptionalDouble efficiency(Point point) {
    OptionalDouble speedUp = speedUp(point);
    return speedUp.isPresent()
        ? OptionalDouble.of(speedUp.getAsDouble() / point.threads())
        : speedUp;
  }

  /** The fastest run of a mode with so many threads, if there is one. */
  Optional<Point> best(SearchMode mode, int threads) {
    return points.stream()
        .filter(p -> p.mode() == mode && p.threads() == threads)
        .max(Comparator.comparingDouble(Point::speed));
  }

  List<SearchMode> modes() {
    return points.stream().map(Point::mode).distinct().toList();
  }

  List<Integer> threads() {
    return points.stream().map(Point::threads).distinct().sorted().toList();
  }

  int mostThreads() {
    return threads().get(threads().size() - 1);
  }

  List<Double> wantedEdges() {
    return points.stream().map(Point::wantedEdge).distinct().sorted().toList();
  }
}
