/**
 * Voxel images of rock, in memory: labels, boxes, and the rule that says which labels are pore.
 *
 * <p>Everywhere in this module a volume of {@code nx} x {@code ny} x {@code nz} voxels is flat, x
 * fastest: voxel {@code (x, y, z)} stands at {@code x + nx*(y + ny*z)}. Files hold the same order,
 * which HDF5 and NumPy call {@code [z][y][x]}. Lengths are in voxels; the voxel edge is in metres.
 */
package org.hdispatch.porous.image;
