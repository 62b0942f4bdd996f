/**
 * Smoothed particle hydrodynamics.
 *
 * <p>Today: the smoothing kernels, with the lattice sums that judge them.
 */
module org.hdispatch.sph {
  exports org.hdispatch.sph;
}
