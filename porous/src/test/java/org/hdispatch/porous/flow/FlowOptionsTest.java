package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FlowOptionsTest {
  @ParameterizedTest
  @ValueSource(doubles = {0, -1e-3, 1, Double.NaN})
  void refusesATolerancesThatNothingCanMeet(double tolerance) {
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class, () -> FlowOptions.DEFAULT.withTolerance(tolerance));
    assertEquals("tolerance must lie between 0 and 1: tolerance=" + tolerance, e.getMessage());
  }

  @Test
  void refusesTauWithoutViscosity() {
    assertThrows(IllegalArgumentException.class, () -> FlowOptions.DEFAULT.withRelaxationTime(0.5));
  }

  @Test
  void refusesNoStepsAndNoLayers() {
    assertThrows(IllegalArgumentException.class, () -> FlowOptions.DEFAULT.withMaxSteps(0));
    assertThrows(IllegalArgumentException.class, () -> FlowOptions.DEFAULT.withInletLayers(0));
  }
}
