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
   * Long along x, for long rows; large, for few links between bundles; and so small that an array
   * of populations stays below 512 KiB, from which on G1 gives it whole regions of a small heap.
   */
  public static final BundleSize DEFAULT = new BundleSize(64, 16, 16);

  /**
   * Bundles that a lattice should be cut into at least, so that several workers share them well.
   */
  private static final int FEW = 32;

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

  /**
   * The default size; 32 x 16 x 16 where that would cut a lattice into fewer than 32 bundles, and
   * 32 x 8 x 8 where this would, too.
   */
  public static BundleSize fitting(Lattice lattice) {
    BundleSize size = DEFAULT;
    for (int halving = 0; halving < 2 && size.pieces(lattice) < FEW; halving++) {
      size = new BundleSize(32, 16 >> halving, 16 >> halving);
    }
    return size;
  }

  private double pieces(Lattice lattice) {
    return Math.ceil((double) lattice.nx() / nx)
        * Math.ceil((double) lattice.ny() / ny)
        * Math.ceil((double) lattice.nz() / nz);
  }

  /** A cube of nodes. */
  public static BundleSize cube(int side) {
    return new BundleSize(side, side, side);
  }
}
