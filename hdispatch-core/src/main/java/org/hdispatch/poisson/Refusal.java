package org.hdispatch.poisson;

/** What is thrown beside the way. */
final class Refusal {
  private Refusal() {}

  static IllegalArgumentException value(
      String rule, String name, double value, int x, int y, int z) {
    return new IllegalArgumentException(
        rule + ": " + name + "=" + value + ", x=" + x + ", y=" + y + ", z=" + z);
  }

  static IllegalArgumentException link(double link, double one, double other) {
    return new IllegalArgumentException(
        "mobility of a link must be finite and not negative: link="
            + link
            + ", nodes="
            + one
            + " and "
            + other);
  }

  static IllegalArgumentException noNode(int x, int y, int z) {
    return new IllegalArgumentException("node must be active: x=" + x + ", y=" + y + ", z=" + z);
  }

  static ArithmeticException residual(double residual, int iteration) {
    return new ArithmeticException(
        "residual must be finite: residual=" + residual + ", iteration=" + iteration);
  }
}
