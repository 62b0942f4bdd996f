package org.hdispatch.lbm.immersed;

import java.util.Objects;

/**
 * A cylinder along a coordinate axis. Its fractions are exact to rounding.
 *
 * @param along its axis
 * @param radius in node spacings
 * @param halfLength half its length; may be infinite
 */
public record Cylinder(Direction along, double radius, double halfLength) implements Shape {
  /** A coordinate axis. */
  public enum Direction {
    /** The first. */
    X,
    /** The second. */
    Y,
    /** The third. */
    Z
  }

  /**
   * Checks the lengths.
   *
   * @throws IllegalArgumentException if the radius or half the length is not positive, or the
   *     radius not finite
   */
  public Cylinder {
    Objects.requireNonNull(along, "along");
    if (!(radius > 0 && radius < Double.POSITIVE_INFINITY && halfLength > 0)) {
      throw new IllegalArgumentException(
          "cylinder must have a positive radius and length: radius="
              + radius
              + ", half length="
              + halfLength);
    }
  }

  /** A cylinder without ends. */
  public static Cylinder endless(Direction along, double radius) {
    return new Cylinder(along, radius, Double.POSITIVE_INFINITY);
  }

  @Override
  public double fraction(double x, double y, double z) {
    return switch (along) {
      case X -> Box.overlap(x, halfLength) * disc(y, z);
      case Y -> Box.overlap(y, halfLength) * disc(z, x);
      case Z -> Box.overlap(z, halfLength) * disc(x, y);
    };
  }

  private double disc(double a, double b) {
    double distance = Math.sqrt(a * a + b * b);
    if (distance >= radius + 0.7072) { // half the diagonal of a square is 0.70711
      return 0;
    }
    return distance <= radius - 0.7072
        ? 1
        : Math.min(1, DiscCells.area(radius, a - 0.5, a + 0.5, b - 0.5, b + 0.5));
  }

  @Override
  public double reachX() {
    return along == Direction.X ? halfLength : radius;
  }

  @Override
  public double reachY() {
    return along == Direction.Y ? halfLength : radius;
  }

  @Override
  public double reachZ() {
    return along == Direction.Z ? halfLength : radius;
  }

  @Override
  public double volume() {
    return Math.PI * radius * radius * 2 * halfLength;
  }
}
