package org.hdispatch.porous.block;

/** How a rock's flow is computed. */
public enum Method {
  /** The lattice Boltzmann method, one node a voxel. */
  LBM,
  /** Smoothed particle hydrodynamics, one particle a voxel. */
  SPH
}
