package org.hdispatch.sph.vector;

import org.hdispatch.sph.CubicSpline;
import org.hdispatch.sph.PairModel;
import org.hdispatch.sph.PairSums;
import org.hdispatch.sph.PairSumsProvider;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SmoothingKernel;
import org.hdispatch.sph.WendlandC2;

/** Sums written with the Vector API: a quad of neighbours at once in vector registers. */
public final class VectorSumsProvider implements PairSumsProvider {
  /** For {@link java.util.ServiceLoader}. */
  public VectorSumsProvider() {}

  @Override
  public boolean available() {
    return ModuleLayer.boot().findModule("jdk.incubator.vector").isPresent()
        && VectorSums.quadsFitRegisters();
  }

  @Override
  public boolean serves(SmoothingKernel kernel) {
    return kernel instanceof QuinticSpline
        || kernel instanceof CubicSpline
        || kernel instanceof WendlandC2;
  }

  @Override
  public PairSums sums(PairModel model) {
    SmoothingKernel kernel = model.kernel();
    if (!available() || !serves(kernel)) {
      throw new IllegalStateException(
          "vector sums need --add-modules jdk.incubator.vector, registers of four doubles and one"
              + " of their kernels: kernel="
              + kernel);
    }
    if (kernel instanceof QuinticSpline) {
      return new QuinticSums(model);
    }
    return kernel instanceof CubicSpline ? new CubicSums(model) : new WendlandSums(model);
  }
}
