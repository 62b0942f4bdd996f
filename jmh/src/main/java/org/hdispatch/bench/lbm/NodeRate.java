package org.hdispatch.bench.lbm;

import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/**
 * Counts updates of fluid nodes. In throughput mode with microseconds as the unit of time its score
 * is nodes per microsecond: MLUPS where every node is fluid, else MFLUPS.
 */
@State(Scope.Thread)
@AuxCounters(AuxCounters.Type.OPERATIONS)
public class NodeRate {
  /** Updates of fluid nodes, 10^6 a second when read as a score. */
  public long mflups;
}
