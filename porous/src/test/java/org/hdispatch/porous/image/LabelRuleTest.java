package org.hdispatch.porous.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class LabelRuleTest {

  @Test
  void onlyTheNamedLabelsArePore() {
    LabelRule rule = LabelRule.poreIs(255, 0);
    assertEquals(Phase.PORE, rule.phase(0));
    assertEquals(Phase.PORE, rule.phase(255));
    assertEquals(Phase.SOLID, rule.phase(1));
    assertEquals("pore=0,255", rule.toString());
    assertEquals(LabelRule.poreIs(0, 255), rule);
  }

  @Test
  void labelsOutsideAByteAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> LabelRule.poreIs(256));
    assertThrows(IllegalArgumentException.class, () -> LabelRule.poreIs(-1));
    assertThrows(IllegalArgumentException.class, () -> LabelRule.poreIs());
  }
}
