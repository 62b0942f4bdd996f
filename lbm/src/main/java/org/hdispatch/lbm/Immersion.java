package org.hdispatch.lbm;

import org.hdispatch.cell.CellMap;

/**
 * What lies in the flow and changes the collision of the nodes that it covers. A scheme has at most
 * one, and one belongs to one scheme.
 *
 * <p>Whatever a {@link Worker} stores apart from its scratch belongs to one bundle; the sums over
 * bundles are for {@link #afterStep}.
 */
public interface Immersion {
  /** Learns where it is: called once, when the scheme is built. */
  void placeIn(
      Lattice lattice,
      VelocitySet set,
      Relaxation relaxation,
      Equilibrium equilibrium,
      CellMap<NodalBundle> bundles);

  /** Makes what one worker needs. */
  Worker newWorker();

  /** Sums what the bundles hold, in key order, and moves on; the caller's thread alone. */
  void afterStep();

  /** Treats the bundles of one worker, one after the other, chunk by chunk. */
  interface Worker {
    /**
     * Begins a bundle.
     *
     * @return whether any of its nodes may be covered; if not, {@link #keep} is not called for it
     */
    boolean enter(NodalBundle bundle);

    /**
     * Keeps the populations of the covered nodes of a chunk as they are before collision. The
     * chunks of a bundle hold each of its nodes once, in an order of their own, the same in every
     * step.
     *
     * @param rows before collision: row i holds what arrived along velocity i, less its weight
     * @param numbers of the chunk's nodes in the bundle
     * @param nodes nodes of the chunk, at most 128
     * @return how many times nodes are covered; if 0, {@link #blend} is not called
     */
    int keep(double[][] rows, int[] numbers, int nodes);

    /**
     * Blends the solid's collision into that of the fluid.
     *
     * @param rows the rows of the last {@link #keep}, collided as if they were fluid: row i holds
     *     what leaves <em>against</em> velocity i (see {@link CollisionKernel})
     */
    void blend(double[][] rows);
  }
}
