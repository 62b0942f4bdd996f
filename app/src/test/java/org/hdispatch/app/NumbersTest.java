package org.hdispatch.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class NumbersTest {
  @Test
  void numbersArePlainWhereThatIsReadable() {
    assertEquals("696.51", Numbers.significant(696.5086, 5));
    assertEquals("0.024061", Numbers.significant(0.02406104, 5));
    assertEquals("6.8740e-13", Numbers.significant(6.874006e-13, 5));
    assertEquals("-1.50e+07", Numbers.significant(-1.5e7, 3));
    assertEquals("0", Numbers.significant(0, 5));
    assertEquals("unknown", Numbers.significant(Double.NaN, 5));
  }

  @Test
  void sharesArePercent() {
    assertEquals("12.3 %", Numbers.percent(0.12345));
    assertEquals("unknown", Numbers.percent(Double.POSITIVE_INFINITY));
  }
}
