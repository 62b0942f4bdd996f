package org.hdispatch.bench.dispatch;

import org.hdispatch.bench.peer.Peer;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;

/** A benchmark of steps over a {@link GatherDomain}. The heap is roomy: nothing moves the cells. */
@Fork(
    value = 3,
    jvmArgs = {"-Xms1g", "-Xmx1g", "-Xmn640m"})
public abstract class Gather extends Sweep {
  /** Steps per call. */
  static final int STEPS = 2;

  /** Cells along each axis. */
  @Param("32")
  public int edge;

  private GatherDomain domain;

  /** Makes the domain and starts the threads. */
  final void start(Peer peer, GatherOrder order) {
    domain = new GatherDomain(edge, order);
    start(peer, domain.size(), domain);
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(TaskCount count) {
    for (int step = 0; step < STEPS; step++) {
      run(1, count);
      domain.flip();
    }
  }
}
