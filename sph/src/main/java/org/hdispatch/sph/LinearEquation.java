package org.hdispatch.sph;

/** P = c^2 (rho - rho0) + P_b. */
record LinearEquation(double restDensity, double soundSpeed, double background)
    implements EquationOfState {

  LinearEquation {
    Checks.positive("rest density", "rho0", restDensity);
    Checks.positive("speed of sound", "c", soundSpeed);
    Checks.notNegative("background pressure", "P_b", background);
  }

  @Override
  public double pressure(double density) {
    return soundSpeed * soundSpeed * (density - restDensity) + background;
  }
}
