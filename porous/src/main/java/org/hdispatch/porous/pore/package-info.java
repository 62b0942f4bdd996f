/**
 * The pore space of a rock: which voxels are pore, how porous it is, and whether a fluid can pass.
 *
 * <p>Pores that no flow reaches are counted apart and never filled silently. A rock through which
 * nothing passes is a result, not an error.
 */
package org.hdispatch.porous.pore;
