package org.hdispatch.lbm;

/** Says which lattice points are fluid; the others are solid. */
@FunctionalInterface
public interface NodeMap {
  /** Whether the node at (x, y, z), inside the box, is fluid. */
  boolean fluid(int x, int y, int z);
}
