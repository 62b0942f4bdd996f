package org.hdispatch.lbm.immersed;

/**
 * What is thrown beside the way, apart from the classes that step: those have no string constants,
 * which HotSpot would make when they are compiled.
 */
final class Refusal {
  private Refusal() {}

  static IllegalArgumentException density(double density) {
    return new IllegalArgumentException(
        "density of a free body must be finite and exceed half the fluid's: density=" + density);
  }

  static IllegalArgumentException place(double x, double y, double z) {
    return new IllegalArgumentException(
        "place must lie within 2^30 node spacings of the origin: x=" + x + ", y=" + y + ", z=" + z);
  }

  static IllegalArgumentException velocity(double ux, double uy, double uz) {
    return new IllegalArgumentException(
        "velocity must be finite: ux=" + ux + ", uy=" + uy + ", uz=" + uz);
  }

  static IllegalArgumentException spin(double wx, double wy, double wz) {
    return new IllegalArgumentException(
        "spin must be finite: wx=" + wx + ", wy=" + wy + ", wz=" + wz);
  }

  static IllegalStateException placed(int bodies) {
    return new IllegalStateException("bodies must be in one scheme only: bodies=" + bodies);
  }

  static IllegalStateException immersed(int body) {
    return new IllegalStateException("body must be in one scheme only, and once: body=" + body);
  }
}
