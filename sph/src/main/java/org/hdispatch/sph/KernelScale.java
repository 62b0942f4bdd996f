package org.hdispatch.sph;

/**
 * Smoothing length and dimensions of a kernel, checked, with what every kernel derives from them.
 */
record KernelScale(double smoothingLength, int dimensions) {

  KernelScale {
    if (!(smoothingLength > 0 && Double.isFinite(smoothingLength))) {
      throw new IllegalArgumentException(
          "smoothing length must be positive and finite: h=" + smoothingLength);
    }
    if (dimensions != 2 && dimensions != 3) {
      throw new IllegalArgumentException("dimensions must be 2 or 3: dimensions=" + dimensions);
    }
  }

  /** Factor in front of the kernel: that of the dimension, over h^dimensions. */
  double prefactor(double plane, double space) {
    double h = smoothingLength;
    double factor = dimensions == 2 ? plane / (h * h) : space / (h * h * h);
    if (!(factor > 0 && Double.isFinite(factor))) {
      throw new IllegalArgumentException(
          "1 / h^" + dimensions + " must be a finite number: h=" + smoothingLength);
    }
    return factor;
  }

  /** Text of a kernel: its name, h, dimensions and support. */
  String describe(String name, int support) {
    return name + ", h=" + smoothingLength + ", " + dimensions + "-D, support=" + support + " h";
  }
}
