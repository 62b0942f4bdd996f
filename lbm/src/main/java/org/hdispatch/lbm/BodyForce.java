package org.hdispatch.lbm;

/**
 * A uniform force per mass g, in node spacings per step².
 *
 * @param x first component
 * @param y second component
 * @param z third component
 */
public record BodyForce(double x, double y, double z) {
  /** No force. */
  public static final BodyForce NONE = new BodyForce(0, 0, 0);

  /**
   * Checks the components.
   *
   * @throws IllegalArgumentException if a component is not finite
   */
  public BodyForce {
    if (!Double.isFinite(x) || !Double.isFinite(y) || !Double.isFinite(z)) {
      throw new IllegalArgumentException(
          "body force must be finite: x=" + x + ", y=" + y + ", z=" + z);
    }
  }
}
