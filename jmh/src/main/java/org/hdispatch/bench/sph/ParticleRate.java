package org.hdispatch.bench.sph;

import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/**
 * Counts steps of particles. In throughput mode with microseconds as the unit of time its score is
 * particle-steps per microsecond: MPUPS.
 */
@State(Scope.Thread)
@AuxCounters(AuxCounters.Type.OPERATIONS)
public class ParticleRate {
  /** Steps of particles, 10^6 a second when read as a score. */
  public long mpups;
}
