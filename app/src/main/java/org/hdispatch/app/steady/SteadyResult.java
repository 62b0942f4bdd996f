package org.hdispatch.app.steady;

import java.util.List;
import org.hdispatch.porous.flow.FlowOptions;

/**
 * What came out of a study of steady states.
 *
 * @param options axis, tolerance of the stop rule, limit of steps
 * @param threads workers
 * @param rocks in their order; those that do not percolate are left out
 */
record SteadyResult(FlowOptions options, int threads, List<SteadyComparison> rocks) {
  /** The relative errors of k that a course is asked for, in falling order. */
  static final List<Double> SHARES = List.of(1e-2, 1e-3);

  /** Keeps a copy of the list. */
  SteadyResult {
    rocks = List.copyOf(rocks);
  }

  /** Relative error of k at which a course ends. */
  double close() {
    return Math.min(options.tolerance(), SHARES.get(SHARES.size() - 1)) / 10;
  }

  /** Estimated relative error to which the steady k is computed. */
  double referenceTolerance() {
    return close() / 100;
  }
}
