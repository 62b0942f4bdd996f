package org.hdispatch.sph;

/**
 * What a kernel makes of a square or simple-cubic lattice of particles, which should be that of a
 * continuum.
 *
 * @param neighbours of a particle, inside the support
 * @param numberDensity n = sum_j W(r_j), the particle itself included: what a fluid at rest has. A
 *     particle whose mass is rho0/n has no pressure then
 * @param laplacianFactor effective over true viscosity, sum_j r_j |dW/dr| / (D n): Morris' viscous
 *     term of the velocity field |r|^2, over its true value
 */
public record LatticeSum(int neighbours, double numberDensity, double laplacianFactor) {

  /**
   * The sums for a lattice.
   *
   * @param kernel of 2 or 3 dimensions
   * @param spacing distance of neighbours on the lattice
   * @throws IllegalArgumentException if the spacing is not positive, or less than a hundredth of
   *     the support
   */
  public static LatticeSum of(SmoothingKernel kernel, double spacing) {
    Checks.positive("spacing of the lattice", "dx", spacing);
    double support = kernel.supportRadius();
    if (support > 100 * spacing) {
      throw new IllegalArgumentException(
          "support must be at most 100 spacings of the lattice: support="
              + support
              + ", dx="
              + spacing);
    }
    int reach = (int) Math.ceil(support / spacing);
    int layers = kernel.dimensions() == 3 ? reach : 0;
    int neighbours = 0;
    double density = 0;
    double virial = 0;
    for (int k = -layers; k <= layers; k++) {
      for (int j = -reach; j <= reach; j++) {
        for (int i = -reach; i <= reach; i++) {
          double r = spacing * Math.sqrt(i * i + j * j + k * k);
          density += kernel.w(r);
          virial += r * kernel.dwdr(r);
          if (r > 0 && r < support * (1 - 1e-9)) { // those on its edge have no weight
            neighbours++;
          }
        }
      }
    }
    return new LatticeSum(neighbours, density, -virial / (kernel.dimensions() * density));
  }
}
