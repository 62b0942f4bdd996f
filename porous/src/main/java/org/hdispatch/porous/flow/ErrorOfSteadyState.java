package org.hdispatch.porous.flow;

import java.util.Arrays;

/**
 * Estimates how far a permeability that is still changing is from its final value.
 *
 * <p>Three estimates, and the largest of them counts:
 *
 * <ul>
 *   <li>The decay of its changes, extrapolated. With D1 the range of k over the last sixth of the
 *       steps and D2 that over the sixth before, the changes shrink by r = D1/D2 each time, and D1
 *       r/(1 - r) remains to come. r below 2/3 counts as 2/3, so that a lucky pause is not taken
 *       for the end. Changes that do not shrink tell nothing, unless thousands of them would still
 *       be within the tolerance: those are rounding errors. Particles creep: see {@link
 *       #whereCreeping}.
 *   <li>What the fluxes through the sections of the rock tell, and the decay cannot: that pressure
 *       is still on its way. Where pressure is corrected, that is how far they lie apart ({@link
 *       SectionFlux#unsettled}), else one and a half times how far at most ({@link
 *       SectionFlux#imbalance}).
 *   <li>What momentum alone must leave after so many steps, exp(-t/t_m) with t_m the time of {@link
 *       RelaxationChoice}, for pores two thirds as wide as the hydraulic diameter. It keeps a slow
 *       start at a low viscosity from being taken for a steady state.
 * </ul>
 */
final class ErrorOfSteadyState {
  /** Share of the tolerance below which changes are taken for rounding errors. */
  private static final double ROUNDING = 1e-4;

  private final int leastWindow;
  private final double leastRatio;
  private final double rounding;
  private final boolean creeping;
  private double[] values = new double[64];
  private int count;
  private double unsettled = Double.POSITIVE_INFINITY;
  private double momentum = 1;

  private ErrorOfSteadyState(
      int leastWindow, double leastRatio, boolean creeping, double tolerance) {
    this.creeping = creeping;
    this.leastWindow = leastWindow;
    this.leastRatio = leastRatio;
    rounding = ROUNDING * tolerance;
  }

  /**
   * Of a flow that starts from rest: at least four samples a window.
   *
   * @param tolerance relative error that is aimed at
   */
  static ErrorOfSteadyState wherePlain(double tolerance) {
    return new ErrorOfSteadyState(4, 2.0 / 3, false, tolerance);
  }

  /**
   * Of a flow whose pressure is corrected between samples: each correction leaves a third of the
   * error or so, and one sample makes a window at first; r below 1/2 counts as 1/2.
   *
   * @param tolerance relative error that is aimed at
   */
  static ErrorOfSteadyState whereCorrected(double tolerance) {
    return new ErrorOfSteadyState(1, 0.5, false, tolerance);
  }

  /**
   * Of particles whose pressure is corrected between samples. Pressures that alternate from one
   * particle to the next drive hardly any flow; so they are found by diffusion, and k creeps to its
   * final value as the inverse root of the steps. After a change D over the second half of the
   * steps D/(sqrt(2) - 1) is then still to come, at least; so long a window is not fooled by turns.
   *
   * @param tolerance relative error that is aimed at
   */
  static ErrorOfSteadyState whereCreeping(double tolerance) {
    return new ErrorOfSteadyState(1, 0.5, true, tolerance);
  }

  /**
   * Adds a sample; samples come at equal intervals.
   *
   * @param permeability k, any unit
   * @param pressureLeft change still to come while pressure spreads, relative to k
   * @param momentumLeft share of the momentum still to come, see {@link
   *     RelaxationChoice#momentumLeft}
   */
  void add(double permeability, double pressureLeft, double momentumLeft) {
    if (count == values.length) {
      values = Arrays.copyOf(values, 2 * count);
    }
    values[count++] = permeability;
    unsettled = pressureLeft;
    momentum = momentumLeft;
  }

  /** Relative change of k over the last interval; infinite before there are two samples. */
  double lastChange() {
    return count < 2
        ? Double.POSITIVE_INFINITY
        : Math.abs(values[count - 1] - values[count - 2]) / Math.abs(values[count - 1]);
  }

  /** Estimated relative error of the last k; infinite as long as there are too few samples. */
  double estimate() {
    return Math.max(Math.max(extrapolatedDecay(), creep()), Math.max(unsettled, momentum));
  }

  private double extrapolatedDecay() {
    int window = Math.max(leastWindow, count / 6);
    if (count < 2 * window + 1) {
      return Double.POSITIVE_INFINITY;
    }
    double recent = range(count - 1 - window, count - 1);
    double before = range(count - 1 - 2 * window, count - 1 - window);
    double relative = recent / Math.abs(values[count - 1]);
    if (relative <= rounding) {
      return relative;
    }
    if (recent >= before) {
      return Double.POSITIVE_INFINITY;
    }
    double ratio = Math.max(leastRatio, recent / before);
    return relative * ratio / (1 - ratio);
  }

  private double creep() {
    if (!creeping || count < 2) {
      return 0;
    }
    int half = count / 2;
    double change = range(count - 1 - half, count - 1) / Math.abs(values[count - 1]);
    return change / (1 / Math.sqrt(1 - (double) half / count) - 1);
  }

  private double range(int first, int last) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (int n = first; n <= last; n++) {
      least = Math.min(least, values[n]);
      most = Math.max(most, values[n]);
    }
    return most - least;
  }
}
