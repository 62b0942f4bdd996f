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
    super(
        "cubic spline",
        2,
        smoothingLength,
        dimensions,
        10 / (7 * Math.PI) / 32,
        1 / Math.PI / 32,
        -6);
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

  /** (2 a)^3 - 4 (2 b)^3 = 32 W/s. */
  private static double shapeAt(double q) {
    double a = twicePositive(2 - q);
    double b = twicePositive(1 - q);
    return Math.fma(b * b * b, -4, a * a * a);
  }

  private static double slopeAt(double q) {
    double a = twicePositive(2 - q);
    double b = twicePositive(1 - q);
    return Math.fma(b * b, -4, a * a);
  }

  private static double slopeOverDistanceAt(double q) {
    return slopeAt(q) / q;
  }
}
