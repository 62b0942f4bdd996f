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
  /** Least share of what drives a particle; in a duct one particle wide 0.2 would be right. */
  public static final double LEAST_SHARE = 0.25;

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

  /**
   * The share s of what drives a fluid particle that its own viscous force has to balance: what is
   * left by the curvature of the velocity carried on into walls.
   *
   * <p>At a wall at rest nu v'' = -a, a being the acceleration by all but viscosity, so that the
   * parabola through 0 at the wall and through v_i at d_i takes the value -(d_j/d_i) v_i - a d_j
   * (d_i + d_j)/(2 nu) at the depth d_j. Its second part adds, to the viscous force on the
   * particle, -(1 - s) times that of all the rest:
   *
   * <pre>
   * 1 - s = -sum_j m_ij/(2 mu_i) d_j (d_i + d_j)/n_j (dW/dr)/r
   * </pre>
   *
   * @param bend sum_j m_ij/(n_i n_j) d_j (d_i + d_j)/d_i^2 (dW/dr)/r
   * @param nearness 1/d_i
   * @param volume 1/n_i
   * @param plane what the plane VISCOSITY holds for the particle
   * @return s, from {@link #LEAST_SHARE} to 1
   */
  public double share(double bend, double nearness, double volume, double plane) {
    if (bend == 0) { // far from walls
      return 1;
    }
    double viscosity = mean == ViscosityMean.HARMONIC ? 1 / plane : plane;
    return Math.max(LEAST_SHARE, 1 + bend / (2 * viscosity * volume * nearness * nearness));
  }

  /**
   * What the plane VISCOSITY holds for a phase of this dynamic viscosity: 0 for {@link
   * Phase#TOUCHED}, which stands for the value of the particle that sums are taken for.
   */
  public double plane(double viscosity) {
    return mean == ViscosityMean.HARMONIC && viscosity != Phase.TOUCHED ? 1 / viscosity : viscosity;
  }
}
