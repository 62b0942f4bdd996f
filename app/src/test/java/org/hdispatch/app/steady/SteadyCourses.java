package org.hdispatch.app.steady;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.porous.flow.Approach;
import org.hdispatch.porous.pore.PoreSpace;

/** Made-up courses of k to a steady value of 1. */
final class SteadyCourses {
  private SteadyCourses() {}

  /**
   * A course with these errors at 10, 20, 30 ... steps, 0.1 s each.
   *
   * @param stopAt number of the measurement, from 0, at which the rule stops it; -1: never
   */
  static SteadyCourse course(Approach approach, int stopAt, double... errors) {
    List<SteadyCourse.Point> points = new ArrayList<>();
    for (int n = 0; n < errors.length; n++) {
      points.add(
          new SteadyCourse.Point(
              10L * (n + 1), 0.1 * (n + 1), 0.05 * (n + 1), 1 + errors[n], 2e-3));
    }
    return new SteadyCourse(
        approach, 3, 1, points, Optional.ofNullable(stopAt < 0 ? null : points.get(stopAt)));
  }

  /** Two courses in a rock of ten voxels, so many of them pores. */
  static SteadyComparison rock(int pores, SteadyCourse corrected, SteadyCourse plain) {
    Rock rock =
        new Rock(
            "made <up> & odd",
            PoreSpace.of(10, 1, 1, (x, y, z) -> x < pores),
            Optional.empty(),
            OptionalDouble.of(1e-6),
            new LinkedHashMap<>(),
            List.of("Nobody, nowhere"));
    return new SteadyComparison(
        rock,
        new SteadyComparison.Reference(pores / 10.0, 1000, 4, 1, 1e-7, true, 500),
        corrected,
        plain);
  }
}
