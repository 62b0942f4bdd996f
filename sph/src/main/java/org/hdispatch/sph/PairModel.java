package org.hdispatch.sph;

import java.util.Objects;

/**
 * What the forces between particles depend on.
 *
 * @param kernel the smoothing kernel
 * @param mean the viscosity of two particles
 * @param uniformViscosity dynamic viscosity where all phases have the same one, else NaN
 * @param walled whether there are walls
 * @param wallFactor beta_max: at most so many times its own velocity does a fluid particle differ
 *     from the wall's
 */
public record PairModel(
    SmoothingKernel kernel,
    ViscosityMean mean,
    double uniformViscosity,
    boolean walled,
    double wallFactor) {

  /**
   * Checks the wall factor.
   *
   * @throws IllegalArgumentException if it is less than 1
   */
  public PairModel {
    Objects.requireNonNull(kernel, "kernel");
    Objects.requireNonNull(mean, "mean");
    if (!(wallFactor >= 1 && Double.isFinite(wallFactor))) {
      throw new IllegalArgumentException(
          "wall factor must be at least 1 (Morris et al. 1997): beta_max=" + wallFactor);
    }
  }

  /** Whether viscosity is the same for all pairs: planes after PRESSURE are not read then. */
  public boolean uniform() {
    return !walled && !Double.isNaN(uniformViscosity);
  }

  /** What the plane VISCOSITY holds for a phase of this dynamic viscosity. */
  public double plane(double viscosity) {
    return mean == ViscosityMean.HARMONIC ? 1 / viscosity : viscosity;
  }
}
