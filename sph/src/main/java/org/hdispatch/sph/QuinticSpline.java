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
public final class QuinticSpline implements SmoothingKernel {

  private static final int SUPPORT = 3; // in h

  private final KernelScale scale;
  private final double supportRadius;
  private final double inverseLength;
  private final double valueFactor;
  private final double slopeFactor;

  /**
   * A kernel of one smoothing length.
   *
   * @param smoothingLength h, in the unit of length of the simulation
   * @param dimensions 2 or 3
   * @throws IllegalArgumentException if h is not positive and finite, or dimensions is neither 2
   *     nor 3
   */
  public QuinticSpline(double smoothingLength, int dimensions) {
    this.scale = new KernelScale(smoothingLength, dimensions);
    this.supportRadius = SUPPORT * smoothingLength;
    this.inverseLength = 1 / smoothingLength;
    this.valueFactor = scale.prefactor(7 / (478 * Math.PI), 1 / (120 * Math.PI));
    this.slopeFactor = valueFactor / smoothingLength;
  }

  @Override
  public double w(double r) {
    if (r >= supportRadius) {
      return 0;
    }
    double q = r * inverseLength;
    double a = Math.max(3 - q, 0);
    double b = Math.max(2 - q, 0);
    double c = Math.max(1 - q, 0);
    return valueFactor * (fourth(a) * a - 6 * (fourth(b) * b) + 15 * (fourth(c) * c));
  }

  @Override
  public double dwdr(double r) {
    if (r >= supportRadius) {
      return 0;
    }
    double q = r * inverseLength;
    double a = fourth(Math.max(3 - q, 0));
    double b = fourth(Math.max(2 - q, 0));
    double c = fourth(Math.max(1 - q, 0));
    return -5 * slopeFactor * (a - 6 * b + 15 * c);
  }

  private static double fourth(double x) {
    double square = x * x;
    return square * square;
  }

  @Override
  public double supportRadius() {
    return supportRadius;
  }

  @Override
  public double smoothingLength() {
    return scale.smoothingLength();
  }

  @Override
  public int dimensions() {
    return scale.dimensions();
  }

  @Override
  public String toString() {
    return scale.describe("quintic spline", SUPPORT);
  }
}
