package org.hdispatch.app.draw;

import org.hdispatch.porous.image.Axis;

/**
 * A plane of voxels through a box, as a picture shows it: the first of its two axes runs to the
 * right, the second downwards.
 *
 * @param normal axis across the plane
 * @param at place of the plane along that axis
 * @param nx voxels of the box along x
 * @param ny voxels of the box along y
 * @param nz voxels of the box along z
 */
public record Plane(Axis normal, int at, int nx, int ny, int nz) {
  /** The plane in the middle of a box. */
  public static Plane middle(Axis normal, int nx, int ny, int nz) {
    return new Plane(normal, normal.length(nx, ny, nz) / 2, nx, ny, nz);
  }

  /** Voxels to the right: along x, or y in a plane across x. */
  public int width() {
    return normal == Axis.X ? ny : nx;
  }

  /** Voxels downwards: along z, or y in a plane across z. */
  public int height() {
    return normal == Axis.Z ? ny : nz;
  }

  /** Flat place of a voxel, x fastest. */
  public int voxel(int column, int row) {
    return switch (normal) {
      case X -> at + nx * (column + ny * row);
      case Y -> column + nx * (at + ny * row);
      case Z -> column + nx * (row + ny * at);
    };
  }
}
