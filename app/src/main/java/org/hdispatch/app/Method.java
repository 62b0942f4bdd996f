package org.hdispatch.app;

/** How a rock's flow is computed. */
enum Method {
  /** The lattice Boltzmann method, one node a voxel. */
  LBM,
  /** Smoothed particle hydrodynamics, one particle a voxel. */
  SPH
}
