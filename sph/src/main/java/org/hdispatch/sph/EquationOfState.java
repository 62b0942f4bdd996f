package org.hdispatch.sph;

/** Pressure of a fluid as a function of its density. */
public interface EquationOfState {
  /**
   * Pressure at a density.
   *
   * @param density rho, mass per volume
   * @return P, in the unit of {@code density} times that of {@link #soundSpeed} squared
   */
  double pressure(double density);

  /** Density at which the pressure is the background pressure. */
  double restDensity();

  /** Speed of sound at rest. */
  double soundSpeed();

  /**
   * P = c^2 (rho - rho0) + P_b: rest pressure P_b, c^2 rho0 in Morris, Fox, Zhu (1997).
   *
   * @param restDensity rho0
   * @param soundSpeed c
   * @param background P_b, not negative
   * @throws IllegalArgumentException if rho0 or c is not positive, or P_b is negative
   */
  static EquationOfState linear(double restDensity, double soundSpeed, double background) {
    return new LinearEquation(restDensity, soundSpeed, background);
  }

  /**
   * The same pressure from the same relative density n/n0, for another fluid beside it: then fluids
   * of unlike density are at the same pressure where they are equally dense in number. The speed of
   * sound is c sqrt(rho0 of that state/rho0).
   *
   * @param state of the other fluid
   * @param restDensity rho0 of this one
   * @throws IllegalArgumentException if rho0 is not positive
   */
  static EquationOfState beside(EquationOfState state, double restDensity) {
    return new MatchedEquation(state, restDensity);
  }

  /**
   * The same pressure, but never below zero: for fluids with a free surface, at which the density
   * is found too low, so that it would hold them together like a skin.
   */
  static EquationOfState withoutTension(EquationOfState state) {
    return new TensionlessEquation(state);
  }

  /**
   * P = c^2 rho0/7 ((rho/rho0)^7 - 1) (Cole 1948; Monaghan 1994).
   *
   * @param restDensity rho0
   * @param soundSpeed c
   * @throws IllegalArgumentException if rho0 or c is not positive
   */
  static EquationOfState tait(double restDensity, double soundSpeed) {
    return new TaitEquation(restDensity, soundSpeed);
  }
}
