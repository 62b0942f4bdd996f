package org.hdispatch.poisson;

/** The six sides of a box of nodes. */
public enum Side {
  /** Beside the nodes with x = 0. */
  X_FIRST,
  /** Beside the nodes with x = nx - 1. */
  X_LAST,
  /** Beside the nodes with y = 0. */
  Y_FIRST,
  /** Beside the nodes with y = ny - 1. */
  Y_LAST,
  /** Beside the nodes with z = 0. */
  Z_FIRST,
  /** Beside the nodes with z = nz - 1. */
  Z_LAST;

  /** All sides, for loops that must make nothing; not to be written to. */
  static final Side[] ALL = values();

  /** The axis across this side: 0, 1, 2 for x, y, z. */
  public int axis() {
    return ordinal() / 2;
  }

  /** Direction out of the box: -1 or 1. */
  int outwards() {
    return 2 * (ordinal() % 2) - 1;
  }
}
