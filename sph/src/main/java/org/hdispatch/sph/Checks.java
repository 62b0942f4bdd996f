package org.hdispatch.sph;

/** Checks of numbers that settings are made of. */
final class Checks {
  private Checks() {}

  static void positive(String what, String symbol, double value) {
    if (!(value > 0 && Double.isFinite(value))) {
      throw new IllegalArgumentException(
          what + " must be positive and finite: " + symbol + "=" + value);
    }
  }

  static void finite(String what, String symbol, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(what + " must be finite: " + symbol + "=" + value);
    }
  }

  static void notNegative(String what, String symbol, double value) {
    if (!(value >= 0 && Double.isFinite(value))) {
      throw new IllegalArgumentException(
          what + " must not be negative, and finite: " + symbol + "=" + value);
    }
  }
}
