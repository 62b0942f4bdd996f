package org.hdispatch.porous.survey;

import org.hdispatch.porous.image.VoxelBox;

/**
 * Three lengths along the axes, such as those of a block.
 *
 * @param nx voxels along x, at least 1
 * @param ny voxels along y, at least 1
 * @param nz voxels along z, at least 1
 */
public record Extent(int nx, int ny, int nz) {
  /**
   * Three lengths.
   *
   * @throws IllegalArgumentException if one is below 1
   */
  public Extent {
    if (nx < 1 || ny < 1 || nz < 1) {
      throw new IllegalArgumentException(
          "lengths must be at least 1 voxel: nx=" + nx + ", ny=" + ny + ", nz=" + nz);
    }
  }

  /** A box of these lengths at a place. */
  VoxelBox at(int x0, int y0, int z0) {
    return new VoxelBox(x0, y0, z0, nx, ny, nz);
  }

  /** As the command line takes it: {@code nx,ny,nz}. */
  @Override
  public String toString() {
    return nx + "," + ny + "," + nz;
  }
}
