package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RelaxationTest {
  @ParameterizedTest
  @ValueSource(doubles = {0.51, 0.6, 1, 2, 8})
  void viscosityFollowsFromTauAndBack(double tau) {
    assertEquals((tau - 0.5) / 3, Relaxation.bgk(tau).viscosity(), 1e-15);
    assertEquals((tau - 0.5) / 3, Relaxation.trt(tau).viscosity(), 1e-15);
    assertEquals(tau, Relaxation.relaxationTime(Relaxation.trt(tau).viscosity()), 1e-15 * tau);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.51, 0.6, 1, 2, 8})
  void trtKeepsTheMagicNumber(double tau) {
    Relaxation trt = Relaxation.trt(tau);
    double magic = (1 / trt.omegaPlus() - 0.5) * (1 / trt.omegaMinus() - 0.5);
    assertEquals(3.0 / 16, magic, 1e-13);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.5, 0.48, 0, -1, Double.NaN, Double.POSITIVE_INFINITY})
  void refusesATauThatGivesNoViscosity(double tau) {
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> Relaxation.bgk(tau));
    assertEquals(
        "relaxation time must exceed 0.5 (Leonardi et al. 2011, eq. 8): tau=" + tau,
        e.getMessage());
    assertThrows(IllegalArgumentException.class, () -> Relaxation.trt(tau));
  }

  @Test
  void refusesAMagicNumberThatIsNotPositive() {
    assertThrows(IllegalArgumentException.class, () -> Relaxation.trt(1, 0));
    assertThrows(IllegalArgumentException.class, () -> Relaxation.trt(1, Double.NaN));
    double endless = Double.POSITIVE_INFINITY;
    assertThrows(IllegalArgumentException.class, () -> Relaxation.trt(1, endless));
  }

  @Test
  void refusesRatesThatBlowUp() {
    assertThrows(IllegalArgumentException.class, () -> new Relaxation(2, 1));
    assertThrows(IllegalArgumentException.class, () -> new Relaxation(1, Double.NaN));
  }
}
