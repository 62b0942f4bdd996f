package org.hdispatch.lbm.immersed;

/**
 * A sphere. Its fractions are exact to rounding: a cell's corners cut the ball by three planes
 * each, and what lies beyond three planes has a closed form ({@link #octant}).
 *
 * @param radius in node spacings
 */
public record Sphere(double radius) implements Shape {
  private static final double HALF_DIAGONAL = 0.86603; // of a cell: sqrt(3)/2, rounded up

  /**
   * Checks the radius.
   *
   * @throws IllegalArgumentException if it is not positive and finite
   */
  public Sphere {
    if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("radius must be positive: radius=" + radius);
    }
  }

  @Override
  public double fraction(double x, double y, double z) {
    double distance = Math.sqrt(x * x + y * y + z * z);
    if (distance >= radius + HALF_DIAGONAL) {
      return 0;
    }
    if (distance <= radius - HALF_DIAGONAL) {
      return 1;
    }
    double ax = Math.abs(x);
    double ay = Math.abs(y);
    double az = Math.abs(z);
    return Math.min(1, alongX(ax - 0.5, ax + 0.5, ay - 0.5, ay + 0.5, az - 0.5, az + 0.5));
  }

  // A cell that straddles a plane of symmetry is cut there: the formula is for one octant.

  private double alongX(double x0, double x1, double y0, double y1, double z0, double z1) {
    return x0 >= 0
        ? alongY(x0, x1, y0, y1, z0, z1)
        : alongY(0, x1, y0, y1, z0, z1) + alongY(0, -x0, y0, y1, z0, z1);
  }

  private double alongY(double x0, double x1, double y0, double y1, double z0, double z1) {
    return y0 >= 0
        ? alongZ(x0, x1, y0, y1, z0, z1)
        : alongZ(x0, x1, 0, y1, z0, z1) + alongZ(x0, x1, 0, -y0, z0, z1);
  }

  private double alongZ(double x0, double x1, double y0, double y1, double z0, double z1) {
    return z0 >= 0
        ? corners(x0, x1, y0, y1, z0, z1)
        : corners(x0, x1, y0, y1, 0, z1) + corners(x0, x1, y0, y1, 0, -z0);
  }

  private double corners(double x0, double x1, double y0, double y1, double z0, double z1) {
    double near = octant(x0, y0, z0) - octant(x1, y0, z0) - octant(x0, y1, z0);
    double far = octant(x1, y0, z1) + octant(x0, y1, z1) - octant(x1, y1, z1);
    double volume = near + octant(x1, y1, z0) - octant(x0, y0, z1) + far;
    return Math.max(0, Math.min(volume, (x1 - x0) * (y1 - y0) * (z1 - z0)));
  }

  /**
   * Volume of the ball's part beyond x = a, y = b, z = c, all 0 or more:
   *
   * <pre>
   *   V = (a b s_ab + b c s_bc + c a s_ca)/3 - a b c
   *       - (P(a) theta_a + P(b) theta_b + P(c) theta_c)/2 + R³ E/3
   * </pre>
   *
   * with s_ab = sqrt(R² - a² - b²), P(t) = R² t - t³/3, theta_a the arc of the circle at x = a
   * beyond b and c, theta_a = atan(s_ab/b) - atan(c/s_ca), and E the angles of the triangle that
   * the planes cut out of the sphere, atan(R s_ab/(a b)) and so on, less pi. (From the integral of
   * the disc's part beyond two lines, {@link DiscCells}; sums of angles are taken as products of
   * complex numbers.)
   */
  private double octant(double a, double b, double c) {
    double rest = radius * radius - a * a - b * b - c * c;
    if (rest <= 0) {
      return 0;
    }
    double sab = Math.sqrt(rest + c * c);
    double sbc = Math.sqrt(rest + a * a);
    double sca = Math.sqrt(rest + b * b);
    double caps =
        integral(a) * StrictMath.atan2(sab * sca - b * c, b * sca + c * sab)
            + integral(b) * StrictMath.atan2(sab * sbc - c * a, a * sbc + c * sab)
            + integral(c) * StrictMath.atan2(sca * sbc - a * b, a * sbc + b * sca);
    double prisms = (a * b * sab + b * c * sbc + c * a * sca) / 3 - a * b * c;
    double excess = excess(a * b, radius * sab, b * c, radius * sbc, c * a, radius * sca);
    return prisms - caps / 2 + radius * radius * radius / 3 * excess;
  }

  /** Sum of three angles, less pi: 0 to pi/2. */
  private static double excess(
      double cos1, double sin1, double cos2, double sin2, double cos3, double sin3) {
    double cos = cos1 * cos2 - sin1 * sin2;
    double sin = sin1 * cos2 + cos1 * sin2;
    return StrictMath.atan2(-(sin * cos3 + cos * sin3), sin * sin3 - cos * cos3);
  }

  /** P(t) = R² t - t³/3. */
  private double integral(double t) {
    return t * (radius * radius - t * t / 3);
  }

  @Override
  public double reachX() {
    return radius;
  }

  @Override
  public double reachY() {
    return radius;
  }

  @Override
  public double reachZ() {
    return radius;
  }

  @Override
  public double volume() {
    return 4.0 / 3 * Math.PI * radius * radius * radius;
  }
}
