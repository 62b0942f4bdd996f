package org.hdispatch.porous.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class SpreadTest {
  @Test
  void meansOfOneTwoFour() {
    Spread spread = Spread.of(new double[] {4, 1, 2});
    assertEquals(3, spread.count());
    assertEquals(1, spread.least());
    assertEquals(2, spread.median());
    assertEquals(4, spread.greatest());
    assertEquals(7.0 / 3, spread.arithmetic(), 1e-15);
    assertEquals(2, spread.geometric(), 1e-15);
    assertEquals(3 / 1.75, spread.harmonic(), 1e-15);
    assertEquals(1.5, Spread.of(new double[] {2, 1}).median());
  }

  @Test
  void deviationIsThatOfASample() {
    Spread spread = Spread.of(new double[] {2, 4, 4, 4, 5, 5, 7, 9});
    assertEquals(Math.sqrt(32.0 / 7), spread.deviation(), 1e-15);
    assertEquals(Math.sqrt(32.0 / 7) / 5, spread.variation(), 1e-15);
    assertEquals(Double.NaN, Spread.of(new double[] {3}).deviation());
    assertEquals(0, Spread.of(new double[] {3, 3}).variation());
  }

  @Test
  void zeroBlocksAndNothingIsUnknown() {
    Spread spread = Spread.of(new double[] {0, 3});
    assertEquals(0, spread.geometric());
    assertEquals(0, spread.harmonic());
    assertEquals(1.5, spread.arithmetic());
    assertEquals(0, Spread.of(new double[0]).count());
    assertEquals(Double.NaN, Spread.of(new double[0]).median());
  }
}
