package org.hdispatch.sph;

import java.util.List;
import java.util.Objects;

/** Distances from walls of simple shape. */
public final class Walls {
  private Walls() {}

  /**
   * Two plane walls: fluid at low &lt; y &lt; high.
   *
   * @throws IllegalArgumentException unless low &lt; high
   */
  public static WallDistance slit(double low, double high) {
    checkOrder("y", low, high);
    return (x, y, z) -> Math.min(y - low, high - y);
  }

  /**
   * A rectangular duct along x: fluid at lowY &lt; y &lt; highY, lowZ &lt; z &lt; highZ.
   *
   * @throws IllegalArgumentException unless low &lt; high
   */
  public static WallDistance duct(double lowY, double highY, double lowZ, double highZ) {
    checkOrder("y", lowY, highY);
    checkOrder("z", lowZ, highZ);
    return (x, y, z) -> {
      double outY = Math.max(lowY - y, y - highY);
      double outZ = Math.max(lowZ - z, z - highZ);
      if (outY > 0 && outZ > 0) {
        return -Math.sqrt(outY * outY + outZ * outZ);
      }
      return -Math.max(outY, outZ);
    };
  }

  private static void checkOrder(String axis, double low, double high) {
    if (!(low < high)) {
      throw new IllegalArgumentException(
          "walls must have a distance along " + axis + ": low=" + low + ", high=" + high);
    }
  }

  /** A cylinder along z, a disc in 2-D. */
  public record Cylinder(double x, double y, double radius) {
    /**
     * Checks the radius.
     *
     * @throws IllegalArgumentException if it is not positive
     */
    public Cylinder {
      Checks.positive("radius of a cylinder", "r", radius);
    }
  }

  /** A sphere. */
  public record Sphere(double x, double y, double z, double radius) {
    /**
     * Checks the radius.
     *
     * @throws IllegalArgumentException if it is not positive
     */
    public Sphere {
      Checks.positive("radius of a sphere", "r", radius);
    }
  }

  /**
   * Solid cylinders along z, seen as often as the box repeats itself. Exact in the fluid; in
   * cylinders that overlap it is the depth in the one whose surface is farther.
   *
   * @throws IllegalArgumentException if there are none
   */
  public static WallDistance cylinders(ParticleBox box, List<Cylinder> cylinders) {
    double[][] bodies =
        cylinders.stream()
            .map(c -> new double[] {c.x(), c.y(), 0, c.radius()})
            .toArray(double[][]::new);
    return new RoundWalls(box, true, bodies);
  }

  /**
   * Solid spheres, seen as often as the box repeats itself: an array, or a packing. Exact in the
   * fluid; in spheres that overlap it is the depth in the one whose surface is farther.
   *
   * @throws IllegalArgumentException if there are none, or the box has 2 dimensions
   */
  public static WallDistance spheres(ParticleBox box, List<Sphere> spheres) {
    if (Objects.requireNonNull(box, "box").dimensions() != 3) {
      throw new IllegalArgumentException("spheres need 3 dimensions: dimensions=2");
    }
    double[][] bodies =
        spheres.stream()
            .map(s -> new double[] {s.x(), s.y(), s.z(), s.radius()})
            .toArray(double[][]::new);
    return new RoundWalls(box, false, bodies);
  }
}
