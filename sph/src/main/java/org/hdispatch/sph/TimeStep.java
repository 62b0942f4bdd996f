package org.hdispatch.sph;

import java.util.List;
import java.util.Locale;

/**
 * The limits of the time step (Morris, Fox, Zhu 1997), of which the least rules.
 *
 * @param sound C h/c: the Courant number C, 0.25 as a rule, is the share of the smoothing length
 *     that sound crosses; c is the fastest phase's
 * @param viscosity 0.125 h^2/nu; nu is the largest
 * @param force 0.25 sqrt(h/g); infinite without a force
 * @param pair 0.25 sqrt(h m/F), F being the pairwise force on a particle at a surface; infinite
 *     without such forces
 * @param capillary 0.25 sqrt(rho h^3/(2 pi sigma)): capillary waves as short as the smoothing
 *     length; infinite without surface tension
 */
public record TimeStep(
    double sound, double viscosity, double force, double pair, double capillary) {
  /** The usual Courant number. */
  static final double COURANT = 0.25;

  /** Share of h^2/nu that viscosity allows. */
  public static final double VISCOUS = 0.125;

  /** Limits for these phases under a body force per mass of size g. */
  public static TimeStep of(SmoothingKernel kernel, List<Phase> phases, double g) {
    return of(kernel, phases, g, COURANT);
  }

  /** Limits with another Courant number: see {@link SphSchemeBuilder#courantNumber}. */
  public static TimeStep of(
      SmoothingKernel kernel, List<Phase> phases, double g, double courantNumber) {
    double h = kernel.smoothingLength();
    double c = 0;
    double nu = 0;
    for (Phase phase : phases) {
      c = Math.max(c, phase.state().soundSpeed());
      nu = Math.max(nu, phase.kinematicViscosity());
    }
    return new TimeStep(
        courantNumber * h / c,
        VISCOUS * h * h / nu,
        0.25 * Math.sqrt(h / g),
        Double.POSITIVE_INFINITY,
        Double.POSITIVE_INFINITY);
  }

  /** Limits for these phases with pairwise forces. */
  public static TimeStep of(
      SmoothingKernel kernel, List<Phase> phases, double g, PairForces pairs) {
    TimeStep without = of(kernel, phases, g);
    double h = kernel.smoothingLength();
    double acceleration = 0;
    double rho = Double.POSITIVE_INFINITY;
    for (int a = 0; a < phases.size(); a++) {
      Phase phase = phases.get(a);
      if (phase.solid()) {
        continue;
      }
      rho = Math.min(rho, phase.state().restDensity());
      for (int b = 0; b < phases.size(); b++) {
        double strength = pairs.strength(a, b);
        double force = MeanField.surfaceForce(kernel, phases.get(b), pairs.profile(), strength);
        acceleration = Math.max(acceleration, force / phase.mass());
      }
    }
    double sigma = MeanField.greatestTension(kernel, phases, pairs);
    return new TimeStep(
        without.sound,
        without.viscosity,
        without.force,
        0.25 * Math.sqrt(h / acceleration),
        0.25 * Math.sqrt(rho * h * h * h / (2 * Math.PI * sigma)));
  }

  /** The step allowed: the least of the limits. */
  public double allowed() {
    return Math.min(Math.min(sound, viscosity), Math.min(force, Math.min(pair, capillary)));
  }

  /** Name of the limit that rules. */
  public String rules() {
    double least = allowed();
    return least == viscosity
        ? "viscosity"
        : least == sound
            ? "sound"
            : least == force ? "force" : least == pair ? "pair force" : "capillary waves";
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%.4g by %s (sound %.4g, viscosity %.4g, force %.4g, pair force %.4g, capillary waves"
            + " %.4g)",
        allowed(),
        rules(),
        sound,
        viscosity,
        force,
        pair,
        capillary);
  }
}
