package org.hdispatch.porous.flow;

/**
 * When a flow counts as steady: its estimated error is below the tolerance twice running, or once
 * after three corrections of the pressure.
 */
public final class StopRule {
  /** Corrections before a single estimate below the tolerance is believed. */
  private static final int LEAST_CORRECTIONS = 3;

  private final double tolerance;
  private boolean below;

  /**
   * A rule that has heard nothing yet.
   *
   * @param tolerance estimated relative error of k at which to stop
   */
  public StopRule(double tolerance) {
    this.tolerance = tolerance;
  }

  /**
   * Hears the next measurement.
   *
   * @param errorEstimate estimated relative error of k
   * @param corrections of the pressure so far
   * @return whether the flow counts as steady now
   */
  public boolean isMet(double errorEstimate, int corrections) {
    boolean before = below;
    below = errorEstimate <= tolerance;
    return below && (before || corrections >= LEAST_CORRECTIONS);
  }
}
