package org.hdispatch.sph;

import java.util.Objects;

/** P of another fluid at the same density over rest density. */
record MatchedEquation(EquationOfState state, double restDensity) implements EquationOfState {

  MatchedEquation {
    Objects.requireNonNull(state, "state");
    Checks.positive("rest density", "rho0", restDensity);
  }

  @Override
  public double pressure(double density) {
    return state.pressure(density * (state.restDensity() / restDensity));
  }

  @Override
  public double soundSpeed() {
    return state.soundSpeed() * Math.sqrt(state.restDensity() / restDensity);
  }
}
