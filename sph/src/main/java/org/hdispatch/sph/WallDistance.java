package org.hdispatch.sph;

/** Signed distance from the surface of the walls. Asked by many threads at once. */
@FunctionalInterface
public interface WallDistance {
  /**
   * Distance of a place from the nearest wall.
   *
   * @return positive in the fluid, negative in the solid, in the unit of length
   */
  double at(double x, double y, double z);
}
