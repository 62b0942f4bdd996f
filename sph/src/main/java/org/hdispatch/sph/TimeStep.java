package org.hdispatch.sph;

import java.util.List;
import java.util.Locale;

/**
 * The limits of the time step (Morris, Fox, Zhu 1997), of which the least rules.
 *
 * @param sound 0.25 h/c: sound crosses a quarter of the smoothing length; c is the fastest phase's
 * @param viscosity 0.125 h^2/nu; nu is the largest
 * @param force 0.25 sqrt(h/g); infinite without a force
 */
public record TimeStep(double sound, double viscosity, double force) {
  /** Limits for these phases under a body force per mass of size g. */
  public static TimeStep of(SmoothingKernel kernel, List<Phase> phases, double g) {
    double h = kernel.smoothingLength();
    double c = 0;
    double nu = 0;
    for (Phase phase : phases) {
      c = Math.max(c, phase.state().soundSpeed());
      nu = Math.max(nu, phase.kinematicViscosity());
    }
    return new TimeStep(0.25 * h / c, 0.125 * h * h / nu, 0.25 * Math.sqrt(h / g));
  }

  /** The step allowed: the least of the limits. */
  public double allowed() {
    return Math.min(sound, Math.min(viscosity, force));
  }

  /** Name of the limit that rules. */
  public String rules() {
    double least = allowed();
    return least == viscosity ? "viscosity" : least == sound ? "sound" : "force";
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%.4g by %s (sound %.4g, viscosity %.4g, force %.4g)",
        allowed(),
        rules(),
        sound,
        viscosity,
        force);
  }
}
