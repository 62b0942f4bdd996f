package org.hdispatch.lbm.immersed;

/** How much of a node's collision is the solid's. */
public final class Weighting {
  private Weighting() {}

  /**
   * B = eps (tau - 1/2) / ((1 - eps) + (tau - 1/2)) (Noble, Torczynski 1998): 0 in fluid, 1 in
   * solid. Walls then lie where they should at tau near 0.6: see {@link ImmersedBodies}.
   *
   * @param solidFraction eps, 0 to 1
   * @param relaxationTime tau, in time steps; exceeds 1/2
   */
  public static double of(double solidFraction, double relaxationTime) {
    double lag = relaxationTime - 0.5;
    return solidFraction * lag / (1 - solidFraction + lag);
  }
}
