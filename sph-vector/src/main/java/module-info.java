/** Vector API sums of smoothed particle hydrodynamics. */
module org.hdispatch.sph.vector {
  requires org.hdispatch.sph;
  requires static jdk.incubator.vector;

  provides org.hdispatch.sph.PairSumsProvider with
      org.hdispatch.sph.vector.VectorSumsProvider;
}
