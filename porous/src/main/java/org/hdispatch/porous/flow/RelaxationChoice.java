package org.hdispatch.porous.flow;

import org.hdispatch.lbm.Relaxation;

/**
 * Chooses tau so that the steady state comes soon. With TRT the permeability does not depend on it,
 * the number of steps does.
 *
 * <p>Two things must settle. Momentum, in a tube of radius R, takes t_m = R²/(5.78 nu) (first zero
 * of the Bessel function J_0, squared); R is half the hydraulic diameter. Pressure diffuses through
 * the rock with D = k c_s²/(phi nu) and takes t_p = (L/pi)²/D. The sum is least where the two are
 * equal: nu² = R² k c_s² pi²/(5.78 phi L²). Where the pressure is corrected, only t_m counts.
 */
final class RelaxationChoice {
  /**
   * Bounds. Kozeny-Carman guesses tight rock too open and open packings too tight: measured optima
   * are 0.55 in a limestone of porosity 0.11, 0.65 in a sandstone, 8 around spheres of 1/8.
   */
  private static final double LEAST = 0.53;

  private static final double MOST = 8;
  private static final double BESSEL_ZERO_SQUARED = 5.7832;

  /** BGK permeabilities drift with tau: 1 is what codes that use it use. */
  private static final double BGK = 1;

  /** With the pressure corrected, momentum is all that takes its time: so many steps, t_m. */
  private static final double MOMENTUM_STEPS = 25;

  private static final double LEAST_CORRECTED = 3;
  private static final int LEAST_STEPS = 20;
  private static final int MOST_STEPS = 1000;

  /** Where immersed boundaries lie where they should: see {@code ImmersedBodies}. */
  private static final double IMMERSED = 0.6;

  private RelaxationChoice() {}

  /**
   * Share of its final momentum that a fluid at rest still lacks after some steps, in a tube two
   * thirds as wide as the hydraulic diameter: exp(-5.78 nu t/R²).
   */
  static double momentumLeft(double hydraulicDiameter, double viscosity, long steps) {
    double radius = hydraulicDiameter / 3;
    return Math.exp(-BESSEL_ZERO_SQUARED * viscosity * steps / (radius * radius));
  }

  /** Time in which momentum settles in a tube, R²/(5.78 nu). */
  static double momentumTime(double radius, double viscosity) {
    return radius * radius / (BESSEL_ZERO_SQUARED * viscosity);
  }

  /** The given tau, or else the one that fits the domain. */
  static double choose(FlowOptions options, FlowDomain domain) {
    if (options.relaxationTime().isPresent()) {
      return options.relaxationTime().getAsDouble();
    }
    if (domain.immersed()) {
      return IMMERSED;
    }
    if (options.collision() == CollisionModel.BGK) {
      return BGK;
    }
    double radius = domain.hydraulicDiameter() / 2;
    if (options.approach() == Approach.CORRECTED) {
      double viscosity = radius * radius / (BESSEL_ZERO_SQUARED * MOMENTUM_STEPS);
      return Math.max(LEAST_CORRECTED, Math.min(MOST, Relaxation.relaxationTime(viscosity)));
    }
    double length = domain.length() + 2.0 * domain.layers();
    double viscosity =
        radius
            * Math.PI
            / length
            * Math.sqrt(
                domain.guessedPermeability()
                    / (3 * BESSEL_ZERO_SQUARED * domain.rock().porosity()));
    return Math.max(LEAST, Math.min(MOST, Relaxation.relaxationTime(viscosity)));
  }

  /**
   * Steps after which a correction has shown what it is worth: momentum follows it, and what it has
   * stirred up at large tau has come to rest.
   */
  static int stepsBetweenCorrections(FlowDomain domain, Relaxation relaxation) {
    double radius = domain.hydraulicDiameter() / 2;
    double momentum = momentumTime(radius, relaxation.viscosity());
    double stirred = 10 * Relaxation.relaxationTime(relaxation.viscosity());
    return (int) Math.max(LEAST_STEPS, Math.min(MOST_STEPS, Math.max(momentum / 2, stirred)));
  }
}
