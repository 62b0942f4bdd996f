package org.hdispatch.porous.image;

import java.io.Serializable;

/**
 * A box of voxels inside an image: its first voxel and its size.
 *
 * <p>Units: voxels. The box holds x0 to x0 + nx - 1, and likewise along y and z.
 *
 * @param x0 first voxel along x, from 0
 * @param y0 first voxel along y, from 0
 * @param z0 first voxel along z, from 0
 * @param nx voxels along x, at least 1
 * @param ny voxels along y, at least 1
 * @param nz voxels along z, at least 1
 */
public record VoxelBox(int x0, int y0, int z0, int nx, int ny, int nz) implements Serializable {

  /**
   * A box.
   *
   * @throws IllegalArgumentException if an origin is negative or a size is below 1
   */
  public VoxelBox {
    if (x0 < 0 || y0 < 0 || z0 < 0) {
      throw new IllegalArgumentException(
          "box origin must not be negative: x0=" + x0 + ", y0=" + y0 + ", z0=" + z0);
    }
    if (nx < 1 || ny < 1 || nz < 1) {
      throw new IllegalArgumentException(
          "box size must be at least 1 voxel: nx=" + nx + ", ny=" + ny + ", nz=" + nz);
    }
  }

  /**
   * The box of a whole image.
   *
   * @param nx voxels along x
   * @param ny voxels along y
   * @param nz voxels along z
   * @return the box with origin (0, 0, 0)
   * @throws IllegalArgumentException if a size is below 1
   */
  public static VoxelBox whole(int nx, int ny, int nz) {
    return new VoxelBox(0, 0, 0, nx, ny, nz);
  }

  /**
   * Number of voxels in the box.
   *
   * @return nx ny nz, or {@link Long#MAX_VALUE} when that does not fit
   */
  public long voxels() {
    long plane = (long) nx * ny;
    return plane > Long.MAX_VALUE / nz ? Long.MAX_VALUE : plane * nz;
  }

  /**
   * This box, checked to lie inside an image.
   *
   * @param imageNx voxels of the image along x
   * @param imageNy voxels of the image along y
   * @param imageNz voxels of the image along z
   * @return this box
   * @throws IllegalArgumentException if a part of the box lies outside
   */
  public VoxelBox within(int imageNx, int imageNy, int imageNz) {
    if ((long) x0 + nx > imageNx || (long) y0 + ny > imageNy || (long) z0 + nz > imageNz) {
      throw new IllegalArgumentException(
          "box must lie inside the image: box="
              + this
              + ", image="
              + imageNx
              + "x"
              + imageNy
              + "x"
              + imageNz);
    }
    return this;
  }

  /** The box as the command line takes it: {@code x0,y0,z0,nx,ny,nz}. */
  @Override
  public String toString() {
    return x0 + "," + y0 + "," + z0 + "," + nx + "," + ny + "," + nz;
  }
}
