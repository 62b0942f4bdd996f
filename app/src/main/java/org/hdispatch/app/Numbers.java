package org.hdispatch.app;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;

/** Numbers as people read them. */
final class Numbers {
  private static final double PLAIN_FROM = 1e-3;
  private static final double PLAIN_TO = 1e6;

  private Numbers() {}

  /** A number to some significant digits, without an exponent where that is readable. */
  static String significant(double value, int digits) {
    double size = Math.abs(value);
    if (value == 0) {
      return "0";
    }
    if (!Double.isFinite(value)) {
      return "unknown";
    }
    return size >= PLAIN_FROM && size < PLAIN_TO
        ? new BigDecimal(value).round(new MathContext(digits)).toPlainString()
        : String.format(Locale.ROOT, "%." + (digits - 1) + "e", value);
  }

  /** A share as percent. */
  static String percent(double share) {
    return Double.isFinite(share) ? significant(100 * share, 3) + " %" : "unknown";
  }
}
