package org.hdispatch.bench.lbm;

import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/**
 * The bandwidth of the memory, measured before each iteration, and how much of it the populations
 * use. JMH's own table adds the readings of all iterations up; {@code table.py --metric
 * ofBandwidth} does not.
 */
@State(Scope.Thread)
@AuxCounters(AuxCounters.Type.EVENTS)
public class Bandwidth {
  /** What the same workers move, GB/s: see {@link StreamProbe}. */
  public double bandwidthGBps;

  /**
   * Share of it that the populations need: 2 Q numbers a node and step in place, 3 Q with two
   * copies, whose lines are also read before they are written. More than 1 where they stay in the
   * cache.
   */
  public double ofBandwidth;
}
