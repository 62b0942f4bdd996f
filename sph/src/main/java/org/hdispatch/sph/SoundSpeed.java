package org.hdispatch.sph;

import java.util.Locale;

/**
 * The least speeds of sound that keep the density of a flow within a share d of that at rest
 * (Morris, Fox, Zhu 1997), of which the greatest rules.
 *
 * @param inertia sqrt(U^2/d)
 * @param viscosity sqrt(nu U/(L d))
 * @param force sqrt(F L/d)
 */
public record SoundSpeed(double inertia, double viscosity, double force) {

  /**
   * The speeds for a flow.
   *
   * @param velocity U, greatest speed expected
   * @param viscosity nu, kinematic
   * @param length L of the flow: between walls, or a period
   * @param force F, size of the body force per mass
   * @param change d, share of the density by which it may change, 0.01 to 0.03 as a rule
   * @throws IllegalArgumentException if a number is not positive; the force may be 0
   */
  public static SoundSpeed of(
      double velocity, double viscosity, double length, double force, double change) {
    Checks.positive("velocity", "U", velocity);
    Checks.positive("kinematic viscosity", "nu", viscosity);
    Checks.positive("length", "L", length);
    Checks.notNegative("body force", "F", force);
    Checks.positive("change of density", "d", change);
    return new SoundSpeed(
        velocity / Math.sqrt(change),
        Math.sqrt(viscosity * velocity / (length * change)),
        Math.sqrt(force * length / change));
  }

  /** The speed to take: the greatest. */
  public double needed() {
    return Math.max(inertia, Math.max(viscosity, force));
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%.4g (inertia %.4g, viscosity %.4g, force %.4g)",
        needed(),
        inertia,
        viscosity,
        force);
  }
}
