package org.hdispatch.cell;

/**
 * Packs the integer coordinates (i, j, k) of a cell into a {@code long}, 21 bits each.
 *
 * <p>Keys compare like rows: by k, then j, then i, so that the natural order of the keys runs
 * through the cells with i fastest. Coordinates may be negative.
 */
public final class CellKey {
  /** The key of no cell: no triple of coordinates has it. */
  public static final long NONE = Long.MIN_VALUE;

  /** Smallest coordinate. */
  public static final int MIN = -(1 << 20);

  /** Largest coordinate. */
  public static final int MAX = (1 << 20) - 1;

  static final int BITS = 21;
  private static final long MASK = (1L << BITS) - 1;

  private CellKey() {}

  /**
   * Key of the cell at (i, j, k).
   *
   * @throws IllegalArgumentException if a coordinate lies outside {@link #MIN} to {@link #MAX}
   */
  public static long of(int i, int j, int k) {
    if (i < MIN || i > MAX || j < MIN || j > MAX || k < MIN || k > MAX) {
      throw new IllegalArgumentException(
          "cell coordinates must lie in ["
              + MIN
              + ", "
              + MAX
              + "]: i="
              + i
              + ", j="
              + j
              + ", k="
              + k);
    }
    return (long) (k - MIN) << 2 * BITS | (long) (j - MIN) << BITS | i - MIN;
  }

  /** Whether {@link #of} gives this key for some coordinates. */
  static boolean isKey(long key) {
    return key >= 0;
  }

  /** First coordinate of a key. */
  public static int i(long key) {
    return (int) (key & MASK) + MIN;
  }

  /** Second coordinate of a key. */
  public static int j(long key) {
    return (int) (key >>> BITS & MASK) + MIN;
  }

  /** Third coordinate of a key. */
  public static int k(long key) {
    return (int) (key >>> 2 * BITS & MASK) + MIN;
  }

  /** The key as people read it: {@code (3, 0, 7)}. */
  public static String toString(long key) {
    return key == NONE ? "(none)" : "(" + i(key) + ", " + j(key) + ", " + k(key) + ")";
  }
}
