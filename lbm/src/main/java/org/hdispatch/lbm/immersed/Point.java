package org.hdispatch.lbm.immersed;

/**
 * Three numbers: a place (node coordinates: the node (i, j, k) lies at that place, half-way walls
 * half a node spacing outside the last nodes), a velocity, or a spin (angular velocity).
 *
 * @param x first component
 * @param y second component
 * @param z third component
 */
public record Point(double x, double y, double z) {
  /** 0, 0, 0. */
  public static final Point ZERO = new Point(0, 0, 0);

  /**
   * Checks the components.
   *
   * @throws IllegalArgumentException if one is not finite
   */
  public Point {
    if (!Double.isFinite(x) || !Double.isFinite(y) || !Double.isFinite(z)) {
      throw new IllegalArgumentException(
          "place, velocity and spin must be finite: x=" + x + ", y=" + y + ", z=" + z);
    }
  }
}
