package org.hdispatch.lbm.duct;

import java.util.Arrays;

/**
 * Several readings of one thing.
 *
 * @param least the smallest
 * @param median the middle one, or the mean of the two in the middle
 * @param most the largest
 */
public record Spread(double least, double median, double most) {
  /**
   * Of some readings.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static Spread of(double[] readings) {
    if (readings.length == 0) {
      throw new IllegalArgumentException("readings must number at least 1: readings=0");
    }
    double[] sorted = readings.clone();
    Arrays.sort(sorted);
    int half = sorted.length / 2;
    double median = sorted.length % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
    return new Spread(sorted[0], median, sorted[sorted.length - 1]);
  }
}
