package org.hdispatch.porous.io;

import org.hdispatch.porous.image.VoxelImage;

/**
 * The grid of a VTI file: one cell per voxel.
 *
 * @param nx voxels along x
 * @param ny voxels along y
 * @param nz voxels along z
 * @param spacing edge of a voxel, in metres (or 1 for a grid in voxels)
 * @param originX lower corner of voxel (0, 0, 0) along x, in metres
 * @param originY lower corner of voxel (0, 0, 0) along y, in metres
 * @param originZ lower corner of voxel (0, 0, 0) along z, in metres
 */
public record VtiGrid(
    int nx, int ny, int nz, double spacing, double originX, double originY, double originZ) {

  /**
   * A grid.
   *
   * @throws IllegalArgumentException if a size is below 1, the voxels are too many, the spacing is
   *     not positive and finite or the origin not finite
   */
  public VtiGrid {
    VoxelImage.requireFits(nx, ny, nz);
    if (!(spacing > 0) || spacing == Double.POSITIVE_INFINITY) {
      throw new IllegalArgumentException(
          "spacing must be positive and finite: spacing=" + spacing + " m");
    }
    if (!Double.isFinite(originX + originY + originZ)) {
      throw new IllegalArgumentException(
          "origin must be finite: x=" + originX + " m, y=" + originY + " m, z=" + originZ + " m");
    }
  }

  /**
   * A grid whose voxel (0, 0, 0) has its lower corner at the origin.
   *
   * @param nx voxels along x
   * @param ny voxels along y
   * @param nz voxels along z
   * @param spacing edge of a voxel, in metres (or 1 for a grid in voxels)
   * @return the grid
   * @throws IllegalArgumentException if a size is below 1, the voxels are too many or the spacing
   *     is not positive and finite
   */
  public static VtiGrid atOrigin(int nx, int ny, int nz, double spacing) {
    return new VtiGrid(nx, ny, nz, spacing, 0, 0, 0);
  }

  /**
   * Number of voxels.
   *
   * @return nx ny nz
   */
  public int voxels() {
    return nx * ny * nz;
  }
}
