package org.hdispatch.sph;

/** Is shown particles, between two steps. */
@FunctionalInterface
public interface ParticleVisitor {
  /**
   * Sees a particle.
   *
   * @param id its number among those the scheme began with
   * @param phase number of its phase
   * @param x place along x
   * @param y place along y
   * @param z place along z
   * @param u velocity along x at the time of the place; of a solid the wall's
   * @param v velocity along y
   * @param w velocity along z
   * @param numberDensity n, as the last step found it; NaN before the first
   * @param pressure P of that density; in a fluid with {@link PairForces} also what these add to
   *     it, their virial, so that it is the pressure that Laplace's law is about
   */
  void visit(
      int id,
      int phase,
      double x,
      double y,
      double z,
      double u,
      double v,
      double w,
      double numberDensity,
      double pressure);
}
