package org.hdispatch.porous.flow;

import org.hdispatch.cell.Ends;

/** What bounds the rock at the four sides along the flow. */
public enum Sides {
  /** No-slip walls, half a voxel outside the outermost voxels: a jacketed sample. */
  WALL,
  /** The rock again. */
  PERIODIC,
  /** The rock's mirror image: fluid slips along the side, nothing passes. No nodes are added. */
  MIRROR;

  /** What lies beyond the sides, as percolation sees it: a mirror image connects nothing new. */
  Ends ends() {
    return this == PERIODIC ? Ends.PERIODIC : Ends.OPEN;
  }
}
