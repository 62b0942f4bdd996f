package org.hdispatch.sph;

import java.util.Objects;
import java.util.function.DoubleUnaryOperator;

/**
 * Shape f of a pairwise force, over q = r/H, H being the support radius: positive where particles
 * push each other apart, negative where they attract each other, 0 at and beyond q = 1.
 *
 * <p>Any smooth function may be given. It is kept as (1 - q) times a polynomial, which interpolates
 * it at Chebyshev nodes: no function is called for a pair, and moments are those of the force that
 * acts.
 */
public final class PairProfile {
  /** Coefficients of the polynomial. The loops over pairs write them out. */
  static final int COEFFICIENTS = 13;

  private static final double MOST_ERROR = 1e-3; // of the greatest |f|
  private static final int SAMPLES = 1000;
  private static final int INTERVALS = 1000; // of Simpson's rule

  private final String name;
  private final double[] coefficients; // of the powers of u = 2 q - 1

  private PairProfile(String name, double[] coefficients) {
    this.name = name;
    this.coefficients = coefficients;
  }

  /** f = cos(3 pi q/2) (Tartakovsky, Meakin 2005): changes sign at a third of the support. */
  public static PairProfile cosine() {
    return of("cosine", q -> Math.cos(1.5 * Math.PI * q));
  }

  /**
   * Forces of two Gaussian potentials, in the manner of Tartakovsky, Panchenko (2016):
   *
   * <pre>
   * f = q (1 - q^2)^2 [ A exp(-q^2/(2 a^2)) - exp(-q^2/(2 b^2)) ],   a = 1/5, b = 1/3
   * </pre>
   *
   * <p>with A such that it changes sign at 0.4. It vanishes at q = 0, where the cosine has a cusp,
   * so that particles are less inclined to stay on a lattice: drops yield to weaker forces.
   */
  public static PairProfile gaussians() {
    double near = 12.5; // 1/(2 a^2)
    double far = 4.5; // 1/(2 b^2)
    double factor = Math.exp(0.4 * 0.4 * (near - far));
    return of(
        "gaussians",
        q -> {
          double end = (1 - q * q) * (1 - q * q);
          return q * end * (factor * Math.exp(-near * q * q) - Math.exp(-far * q * q));
        });
  }

  /**
   * A profile of one's own.
   *
   * @param name in texts
   * @param f shape over q = r/H, from 0 to 1; only its form matters, as strengths scale it
   * @throws IllegalArgumentException if f(1) is not 0, or f is not as smooth as a polynomial of
   *     degree 13, to a thousandth of its greatest value
   */
  public static PairProfile of(String name, DoubleUnaryOperator f) {
    Objects.requireNonNull(name, "name");
    double greatest = 0;
    for (int n = 0; n <= SAMPLES; n++) {
      greatest = Math.max(greatest, Math.abs(f.applyAsDouble((double) n / SAMPLES)));
    }
    double end = f.applyAsDouble(1);
    if (!(Math.abs(end) <= 1e-9 * greatest)) { // NaN too
      throw new IllegalArgumentException(
          "profile must vanish at the end of the support: profile=" + name + ", f(1)=" + end);
    }
    PairProfile profile = new PairProfile(name, powers(nodalValues(f)));
    double error = 0;
    for (int n = 0; n <= SAMPLES; n++) {
      double q = (double) n / SAMPLES;
      error = Math.max(error, Math.abs(profile.at(q) - f.applyAsDouble(q)));
    }
    if (!(error <= MOST_ERROR * greatest)) {
      throw new IllegalArgumentException(
          "profile must be as smooth as a polynomial: profile="
              + name
              + ", error="
              + error / greatest);
    }
    return profile;
  }

  private static double node(int n) {
    return Math.cos(Math.PI * (n + 0.5) / COEFFICIENTS);
  }

  private static double[] nodalValues(DoubleUnaryOperator f) {
    double[] values = new double[COEFFICIENTS];
    for (int n = 0; n < COEFFICIENTS; n++) {
      double q = (1 + node(n)) / 2;
      values[n] = f.applyAsDouble(q) / (1 - q);
    }
    return values;
  }

  /** Powers of the polynomial through the values at the nodes, by way of Chebyshev's. */
  private static double[] powers(double[] values) {
    double[] sum = new double[COEFFICIENTS];
    double[] earlier = new double[COEFFICIENTS]; // T_(k-1)
    double[] last = new double[COEFFICIENTS]; // T_k
    last[0] = 1;
    for (int k = 0; k < COEFFICIENTS; k++) {
      double weight = 0;
      for (int n = 0; n < COEFFICIENTS; n++) {
        weight += values[n] * Math.cos(k * Math.PI * (n + 0.5) / COEFFICIENTS);
      }
      weight *= (k == 0 ? 1.0 : 2.0) / COEFFICIENTS;
      double[] next = new double[COEFFICIENTS]; // T_(k+1) = 2 u T_k - T_(k-1), T_1 = u
      for (int power = 0; power < COEFFICIENTS; power++) {
        sum[power] += weight * last[power];
        next[power] = -earlier[power];
        if (power > 0) {
          next[power] += (k == 0 ? 1 : 2) * last[power - 1];
        }
      }
      earlier = last;
      last = next;
    }
    return sum;
  }

  /** f at q = r/H. */
  public double at(double q) {
    double t = Math.min(q, 1);
    double u = Math.fma(2, t, -1);
    double value = coefficients[COEFFICIENTS - 1];
    for (int power = COEFFICIENTS - 2; power >= 0; power--) {
      value = Math.fma(value, u, coefficients[power]);
    }
    return (1 - t) * value;
  }

  /** Integral of q^k f from 0 to 1. */
  public double moment(int k) {
    double sum = 0; // Simpson's rule
    for (int n = 0; n <= INTERVALS; n++) {
      double q = (double) n / INTERVALS;
      double weight = n == 0 || n == INTERVALS ? 1 : n % 2 == 0 ? 2 : 4;
      sum += weight * Math.pow(q, k) * at(q);
    }
    return sum / (3 * INTERVALS);
  }

  /** A power's coefficient. */
  double coefficient(int power) {
    return coefficients[power];
  }

  @Override
  public String toString() {
    return name;
  }
}
