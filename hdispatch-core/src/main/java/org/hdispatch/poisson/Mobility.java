package org.hdispatch.poisson;

/**
 * Mobility of the nodes of a box; it also says which of them are active. Several workers may ask at
 * the same time.
 */
@FunctionalInterface
public interface Mobility {
  /**
   * Mobility of the node at (x, y, z), inside the box: positive, or 0 where there is no active
   * node.
   */
  double at(int x, int y, int z);
}
