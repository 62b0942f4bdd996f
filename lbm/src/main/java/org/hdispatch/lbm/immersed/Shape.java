package org.hdispatch.lbm.immersed;

/**
 * A solid, by the share that it takes of any unit cell. Coordinates are relative to the shape's
 * centre, lengths in node spacings; a cell is a cube of edge 1.
 */
public interface Shape {
  /**
   * Solid fraction of the unit cell centred at (x, y, z).
   *
   * @return 0, outside, to 1, inside
   */
  double fraction(double x, double y, double z);

  /** Farthest extent from the centre along x; infinite if the shape has no end there. */
  double reachX();

  /** Farthest extent from the centre along y. */
  double reachY();

  /** Farthest extent from the centre along z. */
  double reachZ();

  /** Volume, in node spacings³; infinite if the shape has no end. */
  double volume();
}
