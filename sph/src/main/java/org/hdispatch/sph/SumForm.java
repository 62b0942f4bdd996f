package org.hdispatch.sph;

import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Supplier;

/** The forms in which sums over neighbours are computed. They give the same bits. */
public enum SumForm {
  /** Plain Java: any JVM, any kernel. */
  SCALAR,
  /**
   * Vector instructions asked for by name: needs the artifact {@code hdispatch-sph-vector} and
   * {@code --add-modules jdk.incubator.vector}.
   */
  VECTOR;

  /** The fastest form that this JVM has for a kernel. */
  public static SumForm fastest(SmoothingKernel kernel) {
    return provider(kernel).isPresent() ? VECTOR : SCALAR;
  }

  private static Optional<PairSumsProvider> provider(SmoothingKernel kernel) {
    return ServiceLoader.load(PairSumsProvider.class, PairSumsProvider.class.getClassLoader())
        .stream()
        .map(ServiceLoader.Provider::get)
        .filter(PairSumsProvider::available)
        .filter(provider -> provider.serves(kernel))
        .findFirst();
  }

  /**
   * What makes the loops of a worker.
   *
   * @throws IllegalStateException if this JVM does not have this form for the kernel
   */
  public Supplier<PairSums> of(PairModel model) {
    if (this == SCALAR) {
      return () -> new ScalarSums(model);
    }
    PairSumsProvider provider =
        provider(model.kernel())
            .orElseThrow(
                () ->
                    new IllegalStateException(
                        "vector sums need hdispatch-sph-vector, --add-modules"
                            + " jdk.incubator.vector and one of its kernels: kernel="
                            + model.kernel()));
    return () -> provider.sums(model);
  }
}
