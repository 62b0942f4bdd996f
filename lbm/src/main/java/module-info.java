/** The lattice Boltzmann method as task kernels over nodal bundles. */
module org.hdispatch.lbm {
  requires transitive org.hdispatch.core;

  exports org.hdispatch.lbm;

  uses org.hdispatch.lbm.CollisionKernels;
}
