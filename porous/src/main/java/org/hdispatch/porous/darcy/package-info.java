/**
 * Darcy's law: from a flux and its drive to a permeability, and from a permeability to flow in
 * physical units. The only place where the voxel edge is squared.
 */
package org.hdispatch.porous.darcy;
