package org.hdispatch.sph;

/**
 * The quintic spline, of support 3 h: the default kernel (Morris, Fox, Zhu 1997, with h = dx).
 *
 * <p>With q = r/h and (x)+ = max(x, 0):
 *
 * <pre>
 * W = s [ (3 - q)+^5 - 6 (2 - q)+^5 + 15 (1 - q)+^5 ],   s = 7/(478 pi h^2) or 1/(120 pi h^3)
 * </pre>
 *
 * <p>At h = dx it has 24 (2-D) or 92 (3-D) lattice neighbours and errs by 0.1 % in viscosity.
 */
public final class QuinticSpline extends SmoothingKernel {

  /**
   * A kernel of one smoothing length.
   *
   * @param smoothingLength h, in the unit of length of the simulation
   * @param dimensions 2 or 3
   * @throws IllegalArgumentException if h is not positive and finite, or dimensions is neither 2
   *     nor 3
   */
  public QuinticSpline(double smoothingLength, int dimensions) {
    super(
        "quintic spline",
        3,
        smoothingLength,
        dimensions,
        7 / (478 * Math.PI) / 32,
        1 / (120 * Math.PI) / 32,
        -10);
  }

  @Override
  double shape(double q) {
    return shapeAt(q);
  }

  @Override
  double slope(double q) {
    return slopeAt(q);
  }

  @Override
  void shapes(double[] squares, double[] shapes, int count) {
    for (int n = 0; n < count; n++) {
      shapes[n] = shapeAt(Math.sqrt(squares[n]) * inverseLength);
    }
  }

  @Override
  void slopes(double[] squares, double[] slopes, int count) {
    for (int n = 0; n < count; n++) {
      slopes[n] = slopeOverDistanceAt(Math.sqrt(squares[n]) * inverseLength);
    }
  }

  /** (2 a)^5 - 6 (2 b)^5 + 15 (2 c)^5 = 32 W/s. */
  private static double shapeAt(double q) {
    double a = twicePositive(3 - q);
    double b = twicePositive(2 - q);
    double c = twicePositive(1 - q);
    double a2 = a * a;
    double b2 = b * b;
    double c2 = c * c;
    return Math.fma(c2 * c2 * c, 15, Math.fma(b2 * b2 * b, -6, a2 * a2 * a));
  }

  private static double slopeAt(double q) {
    double a = twicePositive(3 - q);
    double b = twicePositive(2 - q);
    double c = twicePositive(1 - q);
    double a2 = a * a;
    double b2 = b * b;
    double c2 = c * c;
    return Math.fma(c2 * c2, 15, Math.fma(b2 * b2, -6, a2 * a2));
  }

  private static double slopeOverDistanceAt(double q) {
    return slopeAt(q) / q;
  }
}
