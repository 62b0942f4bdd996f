/**
 * Steady flow through a pore space by the lattice Boltzmann method, one node a voxel, and the
 * permeability that follows from it.
 */
package org.hdispatch.porous.flow;
