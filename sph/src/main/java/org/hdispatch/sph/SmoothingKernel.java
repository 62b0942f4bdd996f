package org.hdispatch.sph;

/**
 * The weight W(r, h) that a neighbour at distance r has in a smoothed sum.
 *
 * <p>Every kernel is radial, never negative, decreasing in r, normalised so that its integral over
 * the plane (2-D) or over space (3-D) is 1, and exactly 0 at and beyond {@link #supportRadius()}.
 *
 * <p>Implementations are immutable and may be shared by all threads. No method allocates or checks
 * its argument: r must not be negative, and NaN gives an unspecified value.
 */
public interface SmoothingKernel {

  /**
   * Value of the kernel at a distance.
   *
   * @param r distance between two particles, in the unit of the smoothing length
   * @return W(r, h), in 1/length^{@link #dimensions()}
   */
  double w(double r);

  /**
   * Radial derivative of the kernel at a distance.
   *
   * <p>The gradient with respect to particle i is {@code dwdr(r) (r_i - r_j) / r}.
   *
   * @param r distance between two particles, in the unit of the smoothing length
   * @return dW/dr, in 1/length^({@link #dimensions()} + 1); never positive, and 0 at r = 0
   */
  double dwdr(double r);

  /**
   * Distance at and beyond which the kernel is 0.
   *
   * @return a fixed multiple of the smoothing length, in its unit
   */
  double supportRadius();

  /**
   * Length h that scales the kernel.
   *
   * @return h, in the unit of length of the simulation
   */
  double smoothingLength();

  /**
   * Dimensions of the space the kernel is normalised in.
   *
   * @return 2 or 3
   */
  int dimensions();
}
