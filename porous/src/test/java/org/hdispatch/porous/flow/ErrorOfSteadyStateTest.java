package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;

class ErrorOfSteadyStateTest {
  private static final double TOLERANCE = 1e-3;

  @Test
  void knowsNothingBeforeNineSamples() {
    ErrorOfSteadyState error = ErrorOfSteadyState.wherePlain(TOLERANCE);
    assertEquals(Double.POSITIVE_INFINITY, error.lastChange());
    for (int n = 0; n < 8; n++) {
      error.add(1 + Math.pow(0.1, n), 0, 0);
      assertEquals(Double.POSITIVE_INFINITY, error.estimate());
    }
    error.add(1 + 1e-9, 0, 0);
    assertTrue(Double.isFinite(error.estimate()));
  }

  @Test
  void isNeverBelowTheTrueErrorOfOneDecay() {
    for (double rate : new double[] {0.002, 0.01, 0.05, 0.3, 2}) {
      assertBounds(n -> 1 + 0.7 * Math.exp(-rate * n), 1, 400);
      assertBounds(n -> 1 - 0.7 * Math.exp(-rate * n), 1, 400);
    }
  }

  @Test
  void isNotFarAboveTheTrueErrorOfOneDecay() {
    ErrorOfSteadyState error = ErrorOfSteadyState.wherePlain(TOLERANCE);
    double truth = 0;
    for (int n = 0; n < 200; n++) {
      truth = 0.7 * Math.exp(-0.05 * n);
      error.add(1 + truth, 0, 0);
    }
    assertTrue(error.estimate() < 9 * truth, error.estimate() + " against " + truth);
  }

  @Test
  void isNotFooledByASlowDecayOnceTheFastOneIsOver() {
    assertBounds(n -> 1 + 0.02 * Math.exp(-n / 300.0) + Math.exp(-n / 5.0), 1, 3_000, 200);
  }

  @Test
  void isNotFooledByTurnsOnceTheFirstSwingsAreOver() {
    assertBounds(n -> 1 + 0.5 * Math.exp(-n / 40.0) * Math.cos(n / 15.0), 1, 800, 200);
  }

  @Test
  void isNotFooledByParticlesThatCreep() {
    for (double creep : new double[] {0.1, -0.3}) {
      IntToDoubleFunction k = n -> 1 + creep / Math.sqrt(n + 1) + 0.2 * Math.exp(-n / 2.0);
      double last = assertBounds(ErrorOfSteadyState.whereCreeping(TOLERANCE), k, 1, 500, 60);
      double truth = Math.abs(creep) / Math.sqrt(500);
      assertTrue(last < 1.2 * truth, last + " against " + truth);
    }
  }

  /** k as found in a sandstone of 64³, a sample every 22 steps; after 300 it is 0.7 % less. */
  @Test
  void isNotFooledByParticlesThatTurnAndThenCreep() {
    ErrorOfSteadyState error = ErrorOfSteadyState.whereCreeping(1e-2);
    double[] found = {0.02799, 0.027228, 0.0269666, 0.0269755, 0.0270551, 0.0271094, 0.0271165};
    for (double k : found) {
      error.add(k, 0, 0);
    }
    assertTrue(error.estimate() > 1e-2, "" + error.estimate());
  }

  @Test
  void isInfiniteWhileTheChangesGrow() {
    ErrorOfSteadyState error = ErrorOfSteadyState.wherePlain(TOLERANCE);
    for (int n = 0; n < 50; n++) {
      error.add(Math.exp(0.1 * n), 0, 0);
    }
    assertEquals(Double.POSITIVE_INFINITY, error.estimate());
  }

  @Test
  void takesForRoundingWhatThousandsOfWindowsWouldNotAddUpToTheTolerance() {
    for (double jump : new double[] {0.5, 2}) { // of 1e-4 of the tolerance
      ErrorOfSteadyState error = ErrorOfSteadyState.whereCorrected(TOLERANCE);
      for (int n = 0; n < 50; n++) {
        error.add(1 + n % 2 * jump * 1e-7, 0, 0);
      }
      double estimate = jump < 1 ? error.lastChange() : Double.POSITIVE_INFINITY;
      assertEquals(estimate, error.estimate(), 1e-12);
    }
  }

  @Test
  void isNeverBelowTheImbalanceOfTheFluxes() {
    ErrorOfSteadyState error = ErrorOfSteadyState.wherePlain(TOLERANCE);
    for (int n = 0; n < 50; n++) {
      error.add(1, 0.03, 0);
    }
    assertEquals(0.03, error.estimate());
    assertEquals(0, error.lastChange());
  }

  @Test
  void isNeverBelowWhatMomentumLeaves() {
    ErrorOfSteadyState error = ErrorOfSteadyState.wherePlain(TOLERANCE);
    for (int n = 0; n < 50; n++) {
      error.add(1, 0, 0.2);
    }
    assertEquals(0.2, error.estimate());
    assertEquals(0.37, RelaxationChoice.momentumLeft(9, 0.01, 156), 0.01); // R = 3: one e-folding
  }

  private static void assertBounds(IntToDoubleFunction k, double limit, int samples) {
    assertBounds(k, limit, samples, 0);
  }

  private static void assertBounds(IntToDoubleFunction k, double limit, int samples, int from) {
    assertBounds(ErrorOfSteadyState.wherePlain(TOLERANCE), k, limit, samples, from);
  }

  private static double assertBounds(
      ErrorOfSteadyState error, IntToDoubleFunction k, double limit, int samples, int from) {
    for (int n = 0; n < samples; n++) {
      double value = k.applyAsDouble(n);
      error.add(value, 0, 0);
      double truth = Math.abs(value - limit) / value;
      if (n >= from && truth > 1e-12) {
        assertTrue(
            error.estimate() >= 0.999 * truth,
            "sample " + n + ": estimate " + error.estimate() + ", truth " + truth);
      }
    }
    return error.estimate();
  }
}
