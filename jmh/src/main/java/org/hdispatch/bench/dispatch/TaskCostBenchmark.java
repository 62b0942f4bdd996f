package org.hdispatch.bench.dispatch;

import org.hdispatch.bench.peer.Peer;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/**
 * How near to ideal does a step of tasks of about 1 and 50 us come?
 *
 * <p>Score: ns per step; {@code :task} is ns per task. Ideal is {@code SEQUENTIAL} over the number
 * of workers; efficiency is ideal over measured. At 64 cells the score less the ideal is the fixed
 * cost of a step.
 *
 * <p>Expected with two workers on two cores at 1000 cells: pull, static and scatter within 1 % of
 * ideal. At 1 us the shared counter adds 30 ns a task and a transfer of a cache line, fork and
 * join, queue, {@code invokeAll} and virtual threads cost as much as the task or more; at 50 us all
 * come within 10 %, but virtual threads. At 64 cells of 1 us the peers that park pay 10 to 60 us a
 * step, the dispatcher 0.5 to 1.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar TaskCostBenchmark
 * java -jar jmh/target/benchmarks.jar TaskCostBenchmark -p cells=10000 -p work=800
 * }</pre>
 */
public class TaskCostBenchmark extends Sweep {
  /** Steps per call. */
  static final int STEPS = 10;

  /** What sweeps the cells: all there is. */
  @Param public Peer peer;

  /** Number of cells. */
  @Param({"64", "1000"})
  public int cells;

  /** Work per task: see {@link Work}. */
  @Param({"800", "40000"})
  public long work;

  /** Starts the threads. */
  @Setup(Level.Trial)
  public void begin() {
    start(peer, cells, Work.of(CostLaw.UNIFORM, cells, work));
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(TaskCount count, RoundTrip machine) {
    run(STEPS, count);
    machine.report();
  }
}
