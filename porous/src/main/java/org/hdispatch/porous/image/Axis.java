package org.hdispatch.porous.image;

/** An axis of a voxel image; x runs fastest in memory, z slowest. */
public enum Axis {
  /** The fastest axis: columns of a slice. */
  X,
  /** The middle axis: rows of a slice. */
  Y,
  /** The slowest axis: slices (pages of a stack). */
  Z;

  /**
   * Length of a box along this axis.
   *
   * @param nx voxels along x
   * @param ny voxels along y
   * @param nz voxels along z
   * @return the one of the three that belongs to this axis, in voxels
   */
  public int length(int nx, int ny, int nz) {
    return switch (this) {
      case X -> nx;
      case Y -> ny;
      case Z -> nz;
    };
  }
}
