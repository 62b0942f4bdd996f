package org.hdispatch.sph;

import java.util.Objects;

/** max(P, 0). */
record TensionlessEquation(EquationOfState state) implements EquationOfState {

  TensionlessEquation {
    Objects.requireNonNull(state, "state");
  }

  @Override
  public double pressure(double density) {
    return Math.max(state.pressure(density), 0);
  }

  @Override
  public double restDensity() {
    return state.restDensity();
  }

  @Override
  public double soundSpeed() {
    return state.soundSpeed();
  }
}
