package org.hdispatch.porous.flow;

import org.hdispatch.cell.Ends;

/** What bounds the rock at the two ends of the flow. */
public enum Inlet {
  /** A slab of fluid at each end, from which and into which the flow spreads. */
  SLAB,
  /** The rock again: for periodic images. */
  PERIODIC,
  /**
   * A plenum of one pressure at each end, which the fluid leaves and enters at right angles: half a
   * voxel outside the rock, without any layers. It is the flow through the rock beside its mirror
   * image, periodic along the flow, half of it being computed.
   *
   * <p>The body force g stands for the pressure drop rho g L. The flow is the same, node by node:
   * the two differ by a linear pressure, which the linear equilibrium does not see.
   */
  PRESSURE;

  /** What lies beyond the rock, as percolation sees it. */
  Ends ends() {
    return this == PERIODIC ? Ends.PERIODIC : Ends.OPEN;
  }
}
