package org.hdispatch.lbm;

/**
 * The two relaxation rates of a collision: omega+ for the symmetric (even) and omega- for the
 * antisymmetric (odd) part of each pair of opposite populations (Ginzburg, Verhaeghe, d'Humières,
 * Communications in Computational Physics 3, 2008, 427). BGK is the case of equal rates.
 *
 * @param omegaPlus symmetric rate, 0 to 2; it sets the viscosity
 * @param omegaMinus antisymmetric rate, 0 to 2
 */
public record Relaxation(double omegaPlus, double omegaMinus) {
  /**
   * The magic number 3/16: half-way bounce-back walls then lie exactly half-way in a plane channel,
   * at any viscosity.
   */
  public static final double MAGIC_CHANNEL = 3.0 / 16;

  /**
   * Checks both rates.
   *
   * @throws IllegalArgumentException if a rate is not between 0 and 2
   */
  public Relaxation {
    if (!(omegaPlus > 0 && omegaPlus < 2 && omegaMinus > 0 && omegaMinus < 2)) {
      throw new IllegalArgumentException(
          "relaxation rates must lie between 0 and 2: omega+="
              + omegaPlus
              + ", omega-="
              + omegaMinus);
    }
  }

  /**
   * One relaxation time for all populations.
   *
   * @param relaxationTime tau, in time steps; must exceed 1/2
   * @throws IllegalArgumentException if {@code relaxationTime} is not a finite number above 0.5
   */
  public static Relaxation bgk(double relaxationTime) {
    check(relaxationTime);
    return new Relaxation(1 / relaxationTime, 1 / relaxationTime);
  }

  /**
   * Two relaxation times with (tau+ - 1/2)(tau- - 1/2) = {@link #MAGIC_CHANNEL}.
   *
   * @param relaxationTime tau+, in time steps; must exceed 1/2
   * @throws IllegalArgumentException if {@code relaxationTime} is not a finite number above 0.5
   */
  public static Relaxation trt(double relaxationTime) {
    return trt(relaxationTime, MAGIC_CHANNEL);
  }

  /**
   * Two relaxation times with (tau+ - 1/2)(tau- - 1/2) = magic.
   *
   * @param relaxationTime tau+, in time steps; must exceed 1/2
   * @param magic positive; it fixes where bounce-back walls lie
   * @throws IllegalArgumentException if {@code relaxationTime} is not a finite number above 0.5 or
   *     {@code magic} is not positive and finite
   */
  public static Relaxation trt(double relaxationTime, double magic) {
    check(relaxationTime);
    if (!(magic > 0 && magic < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "magic number must be positive and finite: magic=" + magic);
    }
    return new Relaxation(1 / relaxationTime, 1 / (magic / (relaxationTime - 0.5) + 0.5));
  }

  private static void check(double relaxationTime) {
    if (!(relaxationTime > 0.5 && relaxationTime < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "relaxation time must exceed 0.5 (Leonardi et al. 2011, eq. 8): tau=" + relaxationTime);
    }
  }

  /** Relaxation time tau = 1/omega+, in time steps. */
  public double relaxationTime() {
    return 1 / omegaPlus;
  }

  /**
   * Lattice kinematic viscosity nu = (tau - 1/2)/3 (Leonardi et al. 2011, eq. 8), in node spacings²
   * per step.
   */
  public double viscosity() {
    return (relaxationTime() - 0.5) / 3;
  }

  /** The relaxation time of a viscosity, the inverse of {@link #viscosity}. */
  public static double relaxationTime(double viscosity) {
    return 3 * viscosity + 0.5;
  }
}
