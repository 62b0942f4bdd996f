package org.hdispatch.lbm.vector;

import org.hdispatch.lbm.CollisionCoefficients;
import org.hdispatch.lbm.CollisionKernel;
import org.hdispatch.lbm.CollisionKernels;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.VelocitySet;

/**
 * Kernels written with the Vector API: all populations of several nodes at once in vector
 * registers, so that each is read and written once.
 */
public final class VectorKernels implements CollisionKernels {
  /** For {@link java.util.ServiceLoader}. */
  public VectorKernels() {}

  @Override
  public boolean available() {
    return ModuleLayer.boot().findModule("jdk.incubator.vector").isPresent();
  }

  @Override
  public CollisionKernel kernel(CollisionCoefficients coefficients) {
    if (!available()) {
      throw new IllegalStateException(
          "vector kernels need --add-modules jdk.incubator.vector: set=" + coefficients.set());
    }
    boolean linear = coefficients.equilibrium() == Equilibrium.LINEAR;
    if (coefficients.set() == VelocitySet.D3Q15) {
      return linear ? new VectorD3Q15Linear(coefficients) : new VectorD3Q15Quadratic(coefficients);
    }
    return linear ? new VectorD3Q19Linear(coefficients) : new VectorD3Q19Quadratic(coefficients);
  }
}
