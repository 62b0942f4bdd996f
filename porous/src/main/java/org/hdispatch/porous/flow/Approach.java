package org.hdispatch.porous.flow;

/** How a flow gets to its steady state. */
public enum Approach {
  /**
   * From the pressure that Darcy's law gives from node to node, which is corrected every few steps:
   * hundreds of steps, however tight the rock. Where walls are immersed, {@link #PLAIN} is taken.
   */
  CORRECTED,
  /** From rest, by stepping alone: thousands of steps in tight rock. */
  PLAIN
}
