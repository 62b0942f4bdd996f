package org.hdispatch.bench.dispatch;

import org.hdispatch.bench.peer.Peer;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/**
 * How well is a step balanced whose tasks differ in cost: all alike, one in ten heavy, heavy ones
 * side by side?
 *
 * <p>Score: ns per step; {@code :task} is ns per task, of about 5 us in the mean under every law.
 * Ideal is {@code SEQUENTIAL} over the number of workers.
 *
 * <p>Expected with two workers on two cores: pull within 2 % of ideal under every law at 1000
 * cells. Clustered, a static partition has five sixths of the work in its first half and gets no
 * more than 0.6 of two cores; the stream's chunks, cut by number, lose less. Heaviest first is
 * meant for many workers and few cells: two workers gain nothing by it.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar SkewedCostBenchmark
 * }</pre>
 */
public class SkewedCostBenchmark extends Sweep {
  /** Steps per call. */
  static final int STEPS = 10;

  /** What sweeps the cells. */
  @Param({
    "PULL",
    "HEAVIEST_FIRST",
    "STATIC",
    "SCATTER",
    "STREAM",
    "BARRIER_COUNTER",
    "INVOKE_ALL",
    "SEQUENTIAL"
  })
  public Peer peer;

  /** How the work is spread over the cells. */
  @Param({"UNIFORM", "HEAVY_TAILED", "CLUSTERED"})
  public CostLaw law;

  /** Number of cells. */
  @Param({"64", "1000"})
  public int cells;

  /** Mean work per task: see {@link Work}. */
  @Param("4000")
  public long work;

  /** Starts the threads. */
  @Setup(Level.Trial)
  public void begin() {
    start(peer, cells, Work.of(law, cells, work));
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(TaskCount count, RoundTrip machine) {
    run(STEPS, count);
    machine.report();
  }
}
