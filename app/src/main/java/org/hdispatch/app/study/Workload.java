package org.hdispatch.app.study;

/** What is stepped while the collector is watched. */
public enum Workload {
  /** Lattice Boltzmann steps of flow through rock. */
  LBM,
  /** Steps of smoothed particle hydrodynamics in a periodic box. */
  SPH,
  /** Cells that gather their neighbours' values into scratch and write back: bound by memory. */
  BANDWIDTH,
  /** The same, and much arithmetic on the scratch in between: bound by computing. */
  COMPUTE
}
