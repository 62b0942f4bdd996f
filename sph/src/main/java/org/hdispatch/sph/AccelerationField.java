package org.hdispatch.sph;

/**
 * An acceleration of the fluid that depends on the place: a given pressure gradient, say. Asked by
 * many threads at once.
 */
@FunctionalInterface
public interface AccelerationField {
  /**
   * Acceleration at a place.
   *
   * @param acceleration where x, y and z of it go
   */
  void at(double x, double y, double z, double[] acceleration);
}
