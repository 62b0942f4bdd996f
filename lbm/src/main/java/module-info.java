/** The lattice Boltzmann method as task kernels over nodal bundles. */
module org.hdispatch.lbm {
  requires transitive org.hdispatch.core;

  exports org.hdispatch.lbm;
  exports org.hdispatch.lbm.duct;
  exports org.hdispatch.lbm.immersed;

  uses org.hdispatch.lbm.CollisionKernels;
}
