package org.hdispatch.sph;

import java.util.Objects;

/**
 * What particles are made of: a fluid, or a solid whose particles never move.
 *
 * @param name in texts
 * @param solid whether it is a solid
 * @param mass m of one particle
 * @param viscosity dynamic viscosity mu; of a solid {@link #TOUCHED}, or less than the fluid's
 *     where it is to slip
 * @param state pressure from density; that of a solid keeps fluid out
 */
public record Phase(
    String name, boolean solid, double mass, double viscosity, EquationOfState state) {

  /** Viscosity of a solid on which fluid sticks: that of whatever fluid touches it. */
  public static final double TOUCHED = 0;

  /**
   * Checks mass and viscosity.
   *
   * @throws IllegalArgumentException if either is not positive, but for the viscosity {@link
   *     #TOUCHED} of a solid
   */
  public Phase {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(state, "state");
    Checks.positive("mass of a particle of " + name, "m", mass);
    if (!solid || viscosity != TOUCHED) {
      Checks.positive("viscosity of " + name, "mu", viscosity);
    }
  }

  /**
   * A fluid.
   *
   * @param mass m of one particle: its rest density over the number density at rest
   */
  public static Phase fluid(String name, double mass, double viscosity, EquationOfState state) {
    return new Phase(name, false, mass, viscosity, state);
  }

  /** A solid at whose surface this fluid is at rest pressure, and every fluid sticks. */
  public static Phase wallOf(Phase fluid) {
    return new Phase("wall of " + fluid.name, true, fluid.mass, TOUCHED, fluid.state);
  }

  /** Distance of its particles at rest on a lattice: the D-th root of m/rho0. */
  double spacing(int dimensions) {
    return Math.pow(mass / state.restDensity(), 1.0 / dimensions);
  }

  /** Kinematic viscosity nu = mu/rho0. */
  public double kinematicViscosity() {
    return viscosity / state.restDensity();
  }
}
