package org.hdispatch.sph;

/** P = c^2 rho0/7 ((rho/rho0)^7 - 1). */
record TaitEquation(double restDensity, double soundSpeed) implements EquationOfState {
  private static final int EXPONENT = 7;

  TaitEquation {
    Checks.positive("rest density", "rho0", restDensity);
    Checks.positive("speed of sound", "c", soundSpeed);
  }

  @Override
  public double pressure(double density) {
    double ratio = density / restDensity;
    double cube = ratio * ratio * ratio;
    return soundSpeed * soundSpeed * restDensity / EXPONENT * (cube * cube * ratio - 1);
  }
}
