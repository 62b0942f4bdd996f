/** Smoothed particle hydrodynamics. */
module org.hdispatch.sph {
  requires transitive org.hdispatch.core;

  uses org.hdispatch.sph.PairSumsProvider;

  exports org.hdispatch.sph;
  exports org.hdispatch.sph.cases;
}
