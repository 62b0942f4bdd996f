package org.hdispatch.porous.survey;

import java.util.Arrays;

/**
 * What can be said of several values of a positive quantity, such as permeability; all NaN if there
 * is none.
 *
 * @param count how many values there are
 * @param least the least
 * @param median the middle one, or the mean of the two in the middle
 * @param greatest the greatest
 * @param arithmetic sum / count
 * @param geometric exp(mean of the logarithms); 0 if a value is 0
 * @param harmonic count / (sum of the inverses); 0 if a value is 0
 * @param deviation standard deviation of the population that they are a sample of: the root of
 *     sum((value - arithmetic)²)/(count - 1); NaN of a single value
 */
public record Spread(
    int count,
    double least,
    double median,
    double greatest,
    double arithmetic,
    double geometric,
    double harmonic,
    double deviation) {

  /**
   * The spread of some values.
   *
   * @param values not negative; in any order
   */
  public static Spread of(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted); // also so that the sums do not depend on the order
    int n = sorted.length;
    if (n == 0) {
      double none = Double.NaN;
      return new Spread(0, none, none, none, none, none, none, none);
    }
    double sum = 0;
    double logs = 0;
    double inverses = 0;
    for (double each : sorted) {
      sum += each;
      logs += Math.log(each);
      inverses += 1 / each;
    }
    double squares = 0;
    for (double each : sorted) {
      squares += (each - sum / n) * (each - sum / n);
    }
    double median = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
    return new Spread(
        n,
        sorted[0],
        median,
        sorted[n - 1],
        sum / n,
        Math.exp(logs / n),
        n / inverses,
        n > 1 ? Math.sqrt(squares / (n - 1)) : Double.NaN);
  }

  /** Coefficient of variation: deviation / arithmetic; NaN of a single value, or if all are 0. */
  public double variation() {
    return deviation / arithmetic;
  }
}
