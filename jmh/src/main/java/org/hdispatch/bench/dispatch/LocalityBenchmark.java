package org.hdispatch.bench.dispatch;

import org.hdispatch.bench.peer.Peer;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/**
 * What is it worth that a worker pulls from a segment of its own, next to its last cell, before it
 * helps others?
 *
 * <p>Score: ns per step; {@code :task} is ns per task: a cell of 2 KiB that reads its 26
 * neighbours. All peers hand out row by row.
 *
 * <p>Expected with two workers on two cores: pull as fast as static and 1.5 times as fast as the
 * shared counter, which gives adjacent cells to different workers, so that both load the same
 * neighbours. At {@code edge=10} (2 MiB a copy) all lies in the caches, and more so where each
 * worker has its cells of the step before.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar LocalityBenchmark
 * java -jar jmh/target/benchmarks.jar LocalityBenchmark -p edge=8,10,12,16
 * }</pre>
 */
public class LocalityBenchmark extends Gather {
  /** What sweeps the cells. */
  @Param({"PULL", "STATIC", "BARRIER_COUNTER", "SEQUENTIAL"})
  public Peer peer;

  /** Makes the domain and starts the threads. */
  @Setup(Level.Trial)
  public void begin() {
    start(peer, GatherOrder.ROW);
  }
}
