package org.hdispatch.bench.lbm;

import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/**
 * What the nodes of a lattice hold of the heap. JMH's own table adds the readings of all iterations
 * up; {@code table.py --metric bytesPerNode} does not.
 */
@State(Scope.Thread)
@AuxCounters(AuxCounters.Type.EVENTS)
public class Memory {
  /** Bytes of heap per fluid node: see {@link Held}. */
  public double bytesPerNode;
}
