package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class VelocitySetTest {
  private static final double ROUND_OFF = 1e-15;

  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void hasAsManyVelocitiesAsItsNameSays(VelocitySet set) {
    assertEquals("D3Q" + set.size(), set.name());
  }

  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void oppositesPointBackAndPairUp(VelocitySet set) {
    assertEquals(0, set.opposite(0));
    for (int i = 0; i < set.size(); i++) {
      int o = set.opposite(i);
      assertEquals(i, set.opposite(o));
      assertEquals(-set.cx(i), set.cx(o));
      assertEquals(-set.cy(i), set.cy(o));
      assertEquals(-set.cz(i), set.cz(o));
      assertEquals(set.weight(i), set.weight(o));
    }
    for (int p = 1; p <= set.pairs(); p++) {
      assertEquals(2 * p, set.opposite(2 * p - 1));
    }
  }

  /** Moments 0 to 4 are those of a Gaussian of variance 1/3; odd ones vanish. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void weightsAreIsotropicToFourthOrder(VelocitySet set) {
    double cs2 = VelocitySet.SOUND_SPEED_SQUARED;
    assertEquals(1, moment(set), ROUND_OFF);
    for (int a = 0; a < 3; a++) {
      assertEquals(0, moment(set, a), ROUND_OFF);
      for (int b = 0; b < 3; b++) {
        assertEquals(a == b ? cs2 : 0, moment(set, a, b), ROUND_OFF);
        for (int c = 0; c < 3; c++) {
          assertEquals(0, moment(set, a, b, c), ROUND_OFF);
          for (int d = 0; d < 3; d++) {
            int pairs =
                (a == b && c == d ? 1 : 0)
                    + (a == c && b == d ? 1 : 0)
                    + (a == d && b == c ? 1 : 0);
            assertEquals(cs2 * cs2 * pairs, moment(set, a, b, c, d), ROUND_OFF);
          }
        }
      }
    }
  }

  private static double moment(VelocitySet set, int... axes) {
    double sum = 0;
    for (int i = 0; i < set.size(); i++) {
      double term = set.weight(i);
      for (int axis : axes) {
        term *= axis == 0 ? set.cx(i) : axis == 1 ? set.cy(i) : set.cz(i);
      }
      sum += term;
    }
    return sum;
  }
}
