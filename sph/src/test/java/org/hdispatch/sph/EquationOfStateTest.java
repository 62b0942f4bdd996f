package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EquationOfStateTest {
  private static final EquationOfState[] STATES = {
    EquationOfState.linear(1000, 3, 50), EquationOfState.tait(1000, 3)
  };

  @ParameterizedTest
  @ValueSource(doubles = {0.9, 1, 1.05})
  void fluidsSideBySideHaveTheSamePressureAtTheSameNumberDensity(double relative) {
    for (EquationOfState state : STATES) {
      EquationOfState heavy = EquationOfState.beside(state, 4000);
      assertEquals(state.pressure(relative * 1000), heavy.pressure(relative * 4000), 1e-9);
    }
  }

  /** c^2 = dP/drho, here by a difference. */
  @ParameterizedTest
  @ValueSource(doubles = {500, 1000, 4000})
  void soundSpeedIsTheSlopeOfThePressure(double restDensity) {
    for (EquationOfState state : STATES) {
      EquationOfState beside = EquationOfState.beside(state, restDensity);
      double slope = (beside.pressure(restDensity + 1e-3) - beside.pressure(restDensity - 1e-3));
      assertEquals(beside.soundSpeed() * beside.soundSpeed(), slope / 2e-3, 1e-5); // round-off
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {600, 999, 1001})
  void withoutTensionPressureIsNeverNegative(double density) {
    for (EquationOfState state : STATES) {
      EquationOfState free = EquationOfState.withoutTension(state);
      assertEquals(Math.max(0, state.pressure(density)), free.pressure(density));
      assertEquals(state.soundSpeed(), free.soundSpeed());
      assertEquals(state.restDensity(), free.restDensity());
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN})
  void restDensityMustBePositive(double restDensity) {
    assertThrows(
        IllegalArgumentException.class, () -> EquationOfState.beside(STATES[0], restDensity));
  }
}
