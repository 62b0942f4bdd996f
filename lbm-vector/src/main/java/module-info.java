/** Vector API kernels of the lattice Boltzmann method. */
module org.hdispatch.lbm.vector {
  requires org.hdispatch.lbm;
  requires static jdk.incubator.vector;

  provides org.hdispatch.lbm.CollisionKernels with
      org.hdispatch.lbm.vector.VectorKernels;
}
