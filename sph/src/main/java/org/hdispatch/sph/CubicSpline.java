package org.hdispatch.sph;

/**
 * The cubic spline, of support 2 h (Monaghan, Lattanzio 1985).
 *
 * <p>With q = r/h:
 *
 * <pre>
 * W = s (1 - 3/2 q^2 + 3/4 q^3)   q &lt; 1
 *     s/4 (2 - q)^3               1 &lt;= q &lt; 2,   s = 10/(7 pi h^2) or 1/(pi h^3)
 * </pre>
 *
 * <p>At h = dx it has 8 (2-D) or 26 (3-D) lattice neighbours and errs by 1 to 2 % in viscosity.
 */
public final class CubicSpline implements SmoothingKernel {

  private static final int SUPPORT = 2; // in h

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
  public CubicSpline(double smoothingLength, int dimensions) {
    this.scale = new KernelScale(smoothingLength, dimensions);
    this.supportRadius = SUPPORT * smoothingLength;
    this.inverseLength = 1 / smoothingLength;
    this.valueFactor = scale.prefactor(10 / (7 * Math.PI), 1 / Math.PI);
    this.slopeFactor = valueFactor / smoothingLength;
  }

  @Override
  public double w(double r) {
    if (r >= supportRadius) {
      return 0;
    }
    double q = r * inverseLength;
    if (q < 1) {
      return valueFactor * (1 - 0.75 * q * q * (2 - q));
    }
    double a = 2 - q;
    return valueFactor * 0.25 * (a * a * a);
  }

  @Override
  public double dwdr(double r) {
    if (r >= supportRadius) {
      return 0;
    }
    double q = r * inverseLength;
    if (q < 1) {
      return -0.75 * slopeFactor * q * (4 - 3 * q);
    }
    double a = 2 - q;
    return -0.75 * slopeFactor * (a * a);
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
    return scale.describe("cubic spline", SUPPORT);
  }
}
