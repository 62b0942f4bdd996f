package org.hdispatch.app.text;

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

  @Test
  void plainNumbersHaveNoNeedlessDigits() {
    assertEquals("0.1 %", Numbers.plainPercent(1e-3));
    assertEquals("0.0001 %", Numbers.plainPercent(1e-6));
    assertEquals("10000", Numbers.plain(1e4, 6));
    assertEquals("0.00078", Numbers.plain(0.000781, 2));
    assertEquals("3", Numbers.plain(3.0000001, 2));
    assertEquals("2.1 to 3", Numbers.span(2.13, 3.01, 2));
    assertEquals("3", Numbers.span(2.99, 3.01, 2));
  }

  @Test
  void bytesHaveTheUnitThatSuits() {
    assertEquals("0 bytes", Numbers.bytes(0));
    assertEquals("1 byte", Numbers.bytes(1));
    assertEquals("64 KiB", Numbers.bytes(65_536));
    assertEquals("62.9 MiB", Numbers.bytes(66e6));
    assertEquals("1020 GiB", Numbers.bytes(0x1p40)); // to three digits
  }

  @Test
  void ratiosHaveTwoDecimals() {
    assertEquals("1.70", Numbers.ratio(1.7));
    assertEquals("0.99", Numbers.ratio(0.9899));
    assertEquals("unknown", Numbers.ratio(Double.POSITIVE_INFINITY));
  }
}
