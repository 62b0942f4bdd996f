package org.hdispatch.app.text;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;

/** Numbers as people read them. */
public final class Numbers {
  private static final double PLAIN_FROM = 1e-3;
  private static final double PLAIN_TO = 1e6;

  private static final double KIB = 1024;
  private static final String[] UNITS = {"bytes", "KiB", "MiB", "GiB"};

  private Numbers() {}

  /** A number to some significant digits, without an exponent where that is readable. */
  public static String significant(double value, int digits) {
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

  /** A number to some significant digits at most, without needless zeros or an exponent. */
  public static String plain(double value, int digits) {
    return new BigDecimal(value)
        .round(new MathContext(digits))
        .stripTrailingZeros()
        .toPlainString();
  }

  /** What numbers lie between, {@code 2.1 to 3}; one number where the two look alike. */
  public static String span(double least, double most, int digits) {
    String low = plain(least, digits);
    String high = plain(most, digits);
    return low.equals(high) ? low : low + " to " + high;
  }

  /** A number of bytes in the unit that suits it, {@code 64 KiB}. */
  public static String bytes(double bytes) {
    double size = bytes;
    int unit = 0;
    while (size >= KIB && unit < UNITS.length - 1) {
      size /= KIB;
      unit++;
    }
    return plain(size, 3) + " " + (unit == 0 && size == 1 ? "byte" : UNITS[unit]);
  }

  /** So many threads, in words. */
  public static String threads(int count) {
    return count == 1 ? "1 thread" : count + " threads";
  }

  /** How many times one number is another, to two decimals. */
  public static String ratio(double ratio) {
    return Double.isFinite(ratio) ? String.format(Locale.ROOT, "%.2f", ratio) : "unknown";
  }

  /** A share that was given, such as a tolerance, as percent. */
  public static String plainPercent(double share) {
    return plain(100 * share, 6) + " %";
  }

  /** A share as percent. */
  public static String percent(double share) {
    return Double.isFinite(share) ? significant(100 * share, 3) + " %" : "unknown";
  }
}
