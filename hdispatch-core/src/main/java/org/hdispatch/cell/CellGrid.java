package org.hdispatch.cell;

/**
 * A box of cells with coordinates 0 to extent - 1 along each axis, and its neighbours.
 *
 * @param nx cells along x
 * @param ny cells along y
 * @param nz cells along z
 * @param x what lies beyond the ends along x
 * @param y what lies beyond the ends along y
 * @param z what lies beyond the ends along z
 */
public record CellGrid(int nx, int ny, int nz, Ends x, Ends y, Ends z) {

  /**
   * Checks the extents.
   *
   * @throws IllegalArgumentException if an extent is not in 1 to 2^20
   */
  public CellGrid {
    int most = CellKey.MAX + 1;
    if (nx < 1 || ny < 1 || nz < 1 || nx > most || ny > most || nz > most) {
      throw new IllegalArgumentException(
          "cells along an axis must number 1 to "
              + most
              + ": nx="
              + nx
              + ", ny="
              + ny
              + ", nz="
              + nz);
    }
    if ((long) nx * ny > Integer.MAX_VALUE || (long) nx * ny * nz > Integer.MAX_VALUE - 8) {
      throw new IllegalArgumentException(
          "cells must number less than 2^31: nx=" + nx + ", ny=" + ny + ", nz=" + nz);
    }
  }

  /** A grid whose six ends are alike. */
  public static CellGrid of(int nx, int ny, int nz, Ends ends) {
    return new CellGrid(nx, ny, nz, ends, ends, ends);
  }

  /** Number of cells. */
  public int size() {
    return nx * ny * nz;
  }

  /** Keys of all cells, row by row. */
  public long[] keys() {
    long[] keys = new long[size()];
    int n = 0;
    for (int k = 0; k < nz; k++) {
      for (int j = 0; j < ny; j++) {
        for (int i = 0; i < nx; i++) {
          keys[n++] = CellKey.of(i, j, k);
        }
      }
    }
    return keys;
  }

  /**
   * Key of the cell that lies (di, dj, dk) away, {@link CellKey#NONE} beyond an open end.
   *
   * @param key key of a cell of this grid
   */
  public long neighbour(long key, int di, int dj, int dk) {
    int i = x.wrap(CellKey.i(key) + di, nx);
    int j = y.wrap(CellKey.j(key) + dj, ny);
    int k = z.wrap(CellKey.k(key) + dk, nz);
    return i < 0 || j < 0 || k < 0 ? CellKey.NONE : CellKey.of(i, j, k);
  }
}
