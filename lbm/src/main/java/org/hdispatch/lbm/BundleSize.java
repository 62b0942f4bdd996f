package org.hdispatch.lbm;

/**
 * Extent of a nodal bundle in nodes. Bundles at the far ends of a lattice may be cut short. It
 * never changes a result, only the speed: longer along x means longer runs.
 *
 * @param nx nodes along x
 * @param ny nodes along y
 * @param nz nodes along z
 */
public record BundleSize(int nx, int ny, int nz) {
  /**
   * Long along x, for long runs; and so small that one copy of the populations stays below 512 KiB,
   * from which on G1 gives an array whole regions of a small heap to itself.
   */
  public static final BundleSize DEFAULT = new BundleSize(32, 8, 8);

  /**
   * Checks the extents.
   *
   * @throws IllegalArgumentException if an extent is less than 1 or the bundle has 2^25 nodes or
   *     more
   */
  public BundleSize {
    if (nx < 1 || ny < 1 || nz < 1) {
      throw new IllegalArgumentException(
          "bundle must be at least 1 node along each axis: nx=" + nx + ", ny=" + ny + ", nz=" + nz);
    }
    if ((double) nx * ny * nz >= 1 << 25) {
      throw new IllegalArgumentException(
          "bundle must have less than 2^25 nodes: nx=" + nx + ", ny=" + ny + ", nz=" + nz);
    }
  }

  /** Nodes of a full bundle. */
  public int nodes() {
    return nx * ny * nz;
  }

  /** This size, or the lattice's where that is smaller. */
  BundleSize within(Lattice lattice) {
    return new BundleSize(
        Math.min(nx, lattice.nx()), Math.min(ny, lattice.ny()), Math.min(nz, lattice.nz()));
  }

  /** A cube of nodes. */
  public static BundleSize cube(int side) {
    return new BundleSize(side, side, side);
  }
}
