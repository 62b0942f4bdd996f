package org.hdispatch.sph;

/**
 * The weight W(r, h) that a neighbour at distance r has in a smoothed sum.
 *
 * <p>Every kernel is radial, never negative, decreasing in r, normalised so that its integral over
 * the plane (2-D) or over space (3-D) is 1, and exactly 0 at and beyond {@link #supportRadius()}.
 *
 * <p>Kernels are immutable and may be shared by all threads. No method allocates or checks its
 * argument: r must not be negative, and NaN gives an unspecified value.
 */
public abstract class SmoothingKernel {
  private final String name;
  private final int support; // in h
  private final int dimensions;
  private final double smoothingLength;
  private final double supportRadius;

  /** 1/h. */
  protected final double inverseLength;

  /** What the shape of the kernel is multiplied by: in 1/length^dimensions. */
  protected final double valueFactor;

  /** What {@link #slope} over q is multiplied by to give (dW/dr)/r; negative. */
  protected final double slopeFactor;

  /**
   * A kernel of one smoothing length.
   *
   * @param name what it is called in texts
   * @param support its support radius, in h
   * @param smoothingLength h, in the unit of length of the simulation
   * @param dimensions 2 or 3
   * @param plane factor of its shape in 2-D, for h = 1
   * @param space factor of its shape in 3-D, for h = 1
   * @param steepness factor of its slope, over that of its shape
   * @throws IllegalArgumentException if h is not positive and finite, or so small that W is not, or
   *     dimensions is neither 2 nor 3
   */
  protected SmoothingKernel(
      String name,
      int support,
      double smoothingLength,
      int dimensions,
      double plane,
      double space,
      double steepness) {
    if (!(smoothingLength > 0 && Double.isFinite(smoothingLength))) {
      throw new IllegalArgumentException(
          "smoothing length must be positive and finite: h=" + smoothingLength);
    }
    if (dimensions != 2 && dimensions != 3) {
      throw new IllegalArgumentException("dimensions must be 2 or 3: dimensions=" + dimensions);
    }
    double h = smoothingLength;
    this.name = name;
    this.support = support;
    this.dimensions = dimensions;
    this.smoothingLength = h;
    supportRadius = support * h;
    inverseLength = 1 / h;
    valueFactor = dimensions == 2 ? plane / (h * h) : space / (h * h * h);
    slopeFactor = steepness * valueFactor / (h * h);
    if (!(valueFactor > 0 && Double.isFinite(valueFactor))) {
      throw new IllegalArgumentException(
          "1 / h^" + dimensions + " must be a finite number: h=" + h);
    }
  }

  /** W at a distance q = r/h within the support, over {@link #valueFactor}. */
  abstract double shape(double q);

  /** dW/dq at a distance q = r/h within the support, over {@link #slopeFactor} h^2. */
  abstract double slope(double q);

  /** 2 max(x, 0), of the two cheapest operations: no comparison. */
  static double twicePositive(double x) {
    return x + Math.abs(x);
  }

  /**
   * Value of the kernel at a distance.
   *
   * @param r distance between two particles, in the unit of the smoothing length
   * @return W(r, h), in 1/length^{@link #dimensions()}
   */
  public final double w(double r) {
    return r >= supportRadius ? 0 : valueFactor * shape(r * inverseLength);
  }

  /**
   * Radial derivative of the kernel at a distance.
   *
   * <p>The gradient with respect to particle i is {@code dwdr(r) (r_i - r_j) / r}.
   *
   * @param r distance between two particles, in the unit of the smoothing length
   * @return dW/dr, in 1/length^({@link #dimensions()} + 1); never positive, and 0 at r = 0
   */
  public final double dwdr(double r) {
    return r >= supportRadius ? 0 : slopeFactor * smoothingLength * slope(r * inverseLength);
  }

  /**
   * Shapes of the kernel at many distances: 0 beyond the support.
   *
   * @param squares r^2 of each; positive, in the unit of the smoothing length
   * @param shapes where W(r, h) over {@link #valueFactor()} goes
   * @param count how many
   */
  abstract void shapes(double[] squares, double[] shapes, int count);

  /**
   * Radial derivatives of the kernel over the distance, at many distances: 0 beyond the support.
   *
   * @param squares r^2 of each; positive, in the unit of the smoothing length
   * @param slopes where (dW/dr)/r over {@link #slopeFactor()} goes
   * @param count how many
   */
  abstract void slopes(double[] squares, double[] slopes, int count);

  /**
   * Distance at and beyond which the kernel is 0.
   *
   * @return a fixed multiple of the smoothing length, in its unit
   */
  public final double supportRadius() {
    return supportRadius;
  }

  /**
   * Length h that scales the kernel.
   *
   * @return h, in the unit of length of the simulation
   */
  public final double smoothingLength() {
    return smoothingLength;
  }

  /**
   * Dimensions of the space the kernel is normalised in.
   *
   * @return 2 or 3
   */
  public final int dimensions() {
    return dimensions;
  }

  /** 1/h. */
  public final double inverseLength() {
    return inverseLength;
  }

  /** What the shape of the kernel is multiplied by: in 1/length^dimensions. */
  public final double valueFactor() {
    return valueFactor;
  }

  /** What the slope of the kernel is multiplied by: in 1/length^(dimensions + 2), negative. */
  public final double slopeFactor() {
    return slopeFactor;
  }

  @Override
  public final String toString() {
    return name + ", h=" + smoothingLength + ", " + dimensions + "-D, support=" + support + " h";
  }
}
