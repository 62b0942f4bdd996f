package org.hdispatch.sph;

/**
 * The cubic spline, of support 2 h (Monaghan, Lattanzio 1985).
 *
 * <p>With q = r/h and (x)+ = max(x, 0):
 *
 * <pre>
 * W = s [ (2 - q)+^3 / 4 - (1 - q)+^3 ],   s = 10/(7 pi h^2) or 1/(pi h^3)
 * </pre>
 *
 * <p>At h = dx it has 8 (2-D) or 26 (3-D) lattice neighbours and errs by 1 to 2 % in viscosity.
 */
public final class CubicSpline extends SmoothingKernel {

  /**
   * A kernel of one smoothing length.
   *
   * @param smoothingLength h, in the unit of length of the simulation
   * @param dimensions 2 or 3
   * @throws IllegalArgumentException if h is not positive and finite, or dimensions is neither 2
   *     nor 3
   */
  public CubicSpline(double smoothingLength, int dimensions) {
    super("cubic spline", 2, smoothingLength, dimensions, 10 / (7 * Math.PI), 1 / Math.PI);
  }

  @Override
  double shape(double q) {
    return valueAt(q);
  }

  @Override
  double slope(double q) {
    return slopeAt(q);
  }

  @Override
  public void weights(double[] squares, double[] weights, int count) {
    for (int n = 0; n < count; n++) {
      weights[n] = valueFactor * valueAt(Math.sqrt(squares[n]) * inverseLength);
    }
  }

  @Override
  public void slopes(double[] squares, double[] slopes, int count) {
    for (int n = 0; n < count; n++) {
      slopes[n] = slopeFactor * slopeOverDistanceAt(Math.sqrt(squares[n]) * inverseLength);
    }
  }

  private static double valueAt(double q) {
    double a = Math.max(2 - q, 0);
    double b = Math.max(1 - q, 0);
    return Math.fma(b * b * b, -1, 0.25 * (a * a * a));
  }

  private static double slopeAt(double q) {
    double a = Math.max(2 - q, 0);
    double b = Math.max(1 - q, 0);
    return Math.fma(b * b, 3, -0.75 * (a * a));
  }

  private static double slopeOverDistanceAt(double q) {
    return slopeAt(q) / q;
  }
}
