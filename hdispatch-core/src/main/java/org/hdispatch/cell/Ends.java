package org.hdispatch.cell;

/** What lies beyond the two ends of an axis. */
public enum Ends {
  /** Nothing: the axis ends there. */
  OPEN,
  /** The other end: the axis repeats itself. */
  PERIODIC;

  /** A coordinate brought into 0 to extent - 1, or -1 if it lies beyond an open end. */
  public int wrap(int coordinate, int extent) {
    if (coordinate >= 0 && coordinate < extent) {
      return coordinate;
    }
    return this == PERIODIC ? Math.floorMod(coordinate, extent) : -1;
  }
}
