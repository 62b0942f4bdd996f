package org.hdispatch.lbm.immersed;

/**
 * A box with faces normal to the axes. Its fractions are exact.
 *
 * @param x half its edge along x; may be infinite, as the others
 * @param y half its edge along y
 * @param z half its edge along z
 */
public record Box(double x, double y, double z) implements Shape {
  /**
   * Checks the extents.
   *
   * @throws IllegalArgumentException if one is not positive
   */
  public Box {
    if (!(x > 0 && y > 0 && z > 0)) {
      throw new IllegalArgumentException(
          "half edges of a box must be positive: x=" + x + ", y=" + y + ", z=" + z);
    }
  }

  @Override
  public double fraction(double cx, double cy, double cz) {
    return overlap(cx, x) * overlap(cy, y) * overlap(cz, z);
  }

  /** Length that the interval of length 1 round a point shares with -half to half. */
  static double overlap(double centre, double half) {
    double length = Math.min(centre + 0.5, half) - Math.max(centre - 0.5, -half);
    return Math.max(0, Math.min(1, length));
  }

  @Override
  public double reachX() {
    return x;
  }

  @Override
  public double reachY() {
    return y;
  }

  @Override
  public double reachZ() {
    return z;
  }

  @Override
  public double volume() {
    return 8 * x * y * z;
  }
}
