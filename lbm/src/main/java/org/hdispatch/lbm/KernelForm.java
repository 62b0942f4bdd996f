package org.hdispatch.lbm;

import java.util.Objects;
import java.util.Optional;
import java.util.ServiceLoader;

/** The forms in which a collision is computed. All give the same bits; they differ in speed. */
public enum KernelForm {
  /** Node by node, as the formulas stand: the form that the others are compared with. */
  REFERENCE,
  /** Node by node, written out for each lattice and equilibrium: fast on any JVM. */
  SCALAR,
  /**
   * Vector instructions asked for by name: needs the artifact {@code hdispatch-lbm-vector} and
   * {@code --add-modules jdk.incubator.vector}.
   */
  VECTOR;

  /** The fastest form that this JVM can run. */
  public static KernelForm fastest() {
    return provider().isPresent() ? VECTOR : SCALAR;
  }

  private static Optional<CollisionKernels> provider() {
    return ServiceLoader.load(CollisionKernels.class, CollisionKernels.class.getClassLoader())
        .stream()
        .map(ServiceLoader.Provider::get)
        .filter(CollisionKernels::available)
        .findFirst();
  }

  /**
   * Makes kernels of this form.
   *
   * @throws IllegalStateException if this JVM cannot run it
   */
  public CollisionKernels kernels() {
    if (this == VECTOR) {
      return provider()
          .orElseThrow(
              () ->
                  new IllegalStateException(
                      "vector kernels need hdispatch-lbm-vector and --add-modules"
                          + " jdk.incubator.vector: form="
                          + this));
    }
    return new BuiltIn(this);
  }

  /** The forms that any JVM runs. */
  private record BuiltIn(KernelForm form) implements CollisionKernels {
    @Override
    public boolean available() {
      return true;
    }

    @Override
    public CollisionKernel kernel(CollisionCoefficients coefficients) {
      Objects.requireNonNull(coefficients, "coefficients");
      if (form == REFERENCE) {
        return new NodeKernel(coefficients);
      }
      boolean linear = coefficients.equilibrium() == Equilibrium.LINEAR;
      return switch (coefficients.set()) {
        case D3Q15 ->
            linear ? new ScalarD3Q15Linear(coefficients) : new ScalarD3Q15Quadratic(coefficients);
        case D3Q19 ->
            linear ? new ScalarD3Q19Linear(coefficients) : new ScalarD3Q19Quadratic(coefficients);
      };
    }
  }
}
