package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class StopRuleTest {
  @Test
  void believesTwoEstimatesRunning() {
    StopRule rule = new StopRule(1e-3);
    assertFalse(rule.isMet(9e-4, 0));
    assertFalse(rule.isMet(2e-3, 0));
    assertFalse(rule.isMet(1e-3, 0));
    assertTrue(rule.isMet(1e-3, 0));
  }

  @Test
  void believesOneEstimateAfterThreeCorrections() {
    StopRule rule = new StopRule(1e-3);
    assertFalse(rule.isMet(2e-3, 5));
    assertTrue(rule.isMet(1e-3, 3));
    assertFalse(new StopRule(1e-3).isMet(1e-3, 2));
  }

  @Test
  void believesNoEstimateThatIsNoNumber() {
    StopRule rule = new StopRule(1e-3);
    assertFalse(rule.isMet(Double.NaN, 3));
    assertFalse(rule.isMet(Double.POSITIVE_INFINITY, 3));
  }
}
