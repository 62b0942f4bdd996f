package org.hdispatch.porous.survey;

import org.hdispatch.porous.image.VoxelBox;

/**
 * Blocks of one size at equal distances, beginning at the first voxel of a region. They are
 * numbered from 0, x fastest. Where the region ends within a block, there is none.
 *
 * @param region the part of an image that is cut into blocks
 * @param block size of a block
 * @param stride from the first voxel of a block to that of the next; less than the block: they
 *     overlap, more: there are gaps
 */
public record BlockGrid(VoxelBox region, Extent block, Extent stride) {
  /**
   * A grid.
   *
   * @throws IllegalArgumentException if not a single block fits into the region
   */
  public BlockGrid {
    if (block.nx() > region.nx() || block.ny() > region.ny() || block.nz() > region.nz()) {
      throw new IllegalArgumentException(
          "block must fit into the image: block=" + block + ", image or box=" + region);
    }
  }

  private static int whole(int region, int block, int stride) {
    return (region - block) / stride + 1;
  }

  private static int begun(int region, int stride) {
    return (region - 1) / stride + 1;
  }

  private int alongX() {
    return whole(region.nx(), block.nx(), stride.nx());
  }

  private int alongY() {
    return whole(region.ny(), block.ny(), stride.ny());
  }

  private int alongZ() {
    return whole(region.nz(), block.nz(), stride.nz());
  }

  /** Number of blocks. */
  public long blocks() {
    return VoxelBox.whole(alongX(), alongY(), alongZ()).voxels();
  }

  /** Number of blocks that would begin in the region and not end there; they are left out. */
  public long partialBlocks() {
    return VoxelBox.whole(
                begun(region.nx(), stride.nx()),
                begun(region.ny(), stride.ny()),
                begun(region.nz(), stride.nz()))
            .voxels()
        - blocks();
  }

  /**
   * A block, in voxels of the image.
   *
   * @param number its number
   * @throws IllegalArgumentException if there is no such block
   */
  public VoxelBox block(long number) {
    if (number < 0 || number >= blocks()) {
      throw new IllegalArgumentException(
          "block must be 0 to " + (blocks() - 1) + ": block=" + number);
    }
    long plane = (long) alongX() * alongY();
    int i = (int) (number % alongX());
    int j = (int) (number % plane / alongX());
    int k = (int) (number / plane);
    return block.at(
        region.x0() + i * stride.nx(),
        region.y0() + j * stride.ny(),
        region.z0() + k * stride.nz());
  }
}
