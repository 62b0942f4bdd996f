package org.hdispatch.lbm.immersed;

/**
 * All space on one side of a plane through the centre: the solid lies where n.r is negative.
 *
 * <p>The fraction of a cell is the volume of a cube cut by a plane, exact to rounding for every
 * normal: a line's share is linear in the plane's depth, a square's the mean of its lines' and so
 * piecewise quadratic, a cube's the mean of its squares'; the trapezoidal rule and Simpson's are
 * exact on the pieces. (The closed form of Scardovelli and Zaleski, Journal of Computational
 * Physics 164, 2000, 228, loses its digits where two components of the normal are small.)
 *
 * @param nx normal out of the solid, first component; of any length
 * @param ny second component
 * @param nz third component
 */
public record HalfSpace(double nx, double ny, double nz) implements Shape {
  /**
   * Checks the normal.
   *
   * @throws IllegalArgumentException if it is zero or not finite
   */
  public HalfSpace {
    double length = Math.abs(nx) + Math.abs(ny) + Math.abs(nz);
    if (!(length > 0 && length < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "normal must be finite and not zero: nx=" + nx + ", ny=" + ny + ", nz=" + nz);
    }
  }

  @Override
  public double fraction(double x, double y, double z) {
    double a = Math.abs(nx);
    double b = Math.abs(ny);
    double c = Math.abs(nz);
    double sum = a + b + c;
    // In the corner of the cell that lies deepest in the solid, mirrored to the origin, the plane
    // is m.t = depth with 0 <= t <= 1 and m1 + m2 + m3 = 1.
    double depth = 0.5 - (nx * x + ny * y + nz * z) / sum;
    if (depth <= 0) {
      return 0;
    }
    if (depth >= 1) {
      return 1;
    }
    double least = Math.min(a, Math.min(b, c)) / sum;
    double most = Math.max(a, Math.max(b, c)) / sum;
    return Math.min(1, cube(least, Math.max(least, 1 - least - most), most, depth));
  }

  /**
   * Share of the unit cube where m.t is below the depth, m1 being the least: Simpson between kinks.
   */
  private static double cube(double m1, double m2, double m3, double depth) {
    double t1 = kink(depth - m2 - m3, m1);
    double t2 = kink(depth - m3, m1);
    double t3 = kink(depth - m2, m1);
    double t4 = kink(depth, m1);
    return piece(m1, m2, m3, depth, 0, t1)
        + piece(m1, m2, m3, depth, t1, t2)
        + piece(m1, m2, m3, depth, t2, t3)
        + piece(m1, m2, m3, depth, t3, t4);
  }

  private static double piece(
      double m1, double m2, double m3, double depth, double from, double to) {
    double middle = (from + to) / 2;
    return (to - from)
        / 6
        * (square(m2, m3, depth - m1 * from)
            + 4 * square(m2, m3, depth - m1 * middle)
            + square(m2, m3, depth - m1 * to));
  }

  /** Share of the unit square: the trapezoidal rule between the kinks. */
  private static double square(double m2, double m3, double depth) {
    double full = kink(depth - m3, m2); // lines before this are all solid
    double empty = kink(depth, m2); // lines after this are all fluid
    double mean = (line(m3, depth - m2 * full) + line(m3, depth - m2 * empty)) / 2;
    return full + (empty - full) * mean;
  }

  private static double line(double m3, double depth) {
    return Math.max(0, Math.min(1, depth / m3));
  }

  /** Where depth - m t vanishes, brought into 0 to 1. */
  private static double kink(double depth, double m) {
    return depth <= 0 ? 0 : depth >= m ? 1 : depth / m;
  }

  @Override
  public double reachX() {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public double reachY() {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public double reachZ() {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public double volume() {
    return Double.POSITIVE_INFINITY;
  }
}
