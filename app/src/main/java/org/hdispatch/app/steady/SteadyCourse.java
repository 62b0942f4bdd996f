package org.hdispatch.app.steady;

import java.util.List;
import java.util.Optional;
import org.hdispatch.porous.flow.Approach;

/**
 * How k came to its steady value in one run.
 *
 * @param approach which way was taken
 * @param relaxationTime tau
 * @param steady the steady k, voxel²
 * @param points what was measured, in the order of the steps; at least one
 * @param stop where the stop rule found the flow steady; empty if it did not
 */
record SteadyCourse(
    Approach approach,
    double relaxationTime,
    double steady,
    List<Point> points,
    Optional<Point> stop) {

  /** Keeps a copy of the points. */
  SteadyCourse {
    points = List.copyOf(points);
  }

  /**
   * One measurement.
   *
   * @param step steps done
   * @param seconds wall time of these steps and of all that has to do with pressure, s
   * @param secondsPressure of them, those of the pressure, s
   * @param permeability k, voxel²
   * @param errorEstimate what the program then took for the relative error of k
   */
  record Point(
      long step,
      double seconds,
      double secondsPressure,
      double permeability,
      double errorEstimate) {}

  /** Relative error of k at a point: |k/steady - 1|. */
  double error(Point point) {
    return Math.abs(point.permeability() / steady - 1);
  }

  /** The first point from which on the error is never above this share again, if there is one. */
  Optional<Point> within(double share) {
    Optional<Point> first = Optional.empty();
    for (int n = points.size() - 1; n >= 0 && error(points.get(n)) <= share; n--) {
      first = Optional.of(points.get(n));
    }
    return first;
  }

  /** Steps between measurements. */
  long interval() {
    return points.get(0).step();
  }

  Point last() {
    return points.get(points.size() - 1);
  }
}
