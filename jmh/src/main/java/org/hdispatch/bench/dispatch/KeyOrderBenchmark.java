package org.hdispatch.bench.dispatch;

import org.hdispatch.bench.peer.Peer;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/**
 * What does it cost to hand out cells in an order that is no path through space?
 *
 * <p>Score: ns per step; {@code :task} is ns per task: a cell of 2 KiB that reads its 26
 * neighbours. The workers pull.
 *
 * <p>Expected: rows and the Morton curve within 10 % of each other; random 3 to 4 times as slow
 * with one worker.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar KeyOrderBenchmark -p workers=1,2
 * }</pre>
 */
public class KeyOrderBenchmark extends Gather {
  /** Order of hand-out. */
  @Param({"ROW", "MORTON", "RANDOM"})
  public GatherOrder order;

  /** Makes the domain and starts the threads. */
  @Setup(Level.Trial)
  public void begin() {
    start(Peer.PULL, order);
  }
}
