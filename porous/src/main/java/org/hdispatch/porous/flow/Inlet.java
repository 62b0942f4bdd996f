package org.hdispatch.porous.flow;

import org.hdispatch.cell.Ends;

/** What bounds the rock at the two ends of the flow. */
public enum Inlet {
  /** A slab of fluid at each end, from which and into which the flow spreads. */
  SLAB,
  /** The rock again: for periodic images. */
  PERIODIC;

  /** What lies beyond the rock, as percolation sees it. */
  Ends ends() {
    return this == PERIODIC ? Ends.PERIODIC : Ends.OPEN;
  }
}
