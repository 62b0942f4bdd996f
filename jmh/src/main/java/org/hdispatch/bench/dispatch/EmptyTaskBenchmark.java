package org.hdispatch.bench.dispatch;

import org.hdispatch.bench.peer.Peer;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/**
 * What does one empty task cost, and one step of them, with the dispatcher and with its peers?
 *
 * <p>Score: ns per step; {@code :task} is ns per task; {@code SEQUENTIAL} is the tasks alone.
 *
 * <p>Expected with two workers on two cores at 10 000 cells: pull and static 2 to 4 ns a task;
 * scatter and a parallel stream 0.3 to 3; barrier and shared counter 15 to 30; barrier and queue,
 * fork and join, {@code invokeAll} 50 to 300; virtual threads 400. At 64 cells the fixed cost of a
 * step shows: pull, static and scatter less than 2 us, all others 5 us and more.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar EmptyTaskBenchmark
 * }</pre>
 */
public class EmptyTaskBenchmark extends Sweep {
  /** Steps per call, so that what a call costs once does not count. */
  static final int STEPS = 100;

  /** What sweeps the cells: all there is. */
  @Param public Peer peer;

  /** Number of cells. */
  @Param({"64", "1000", "10000"})
  public int cells;

  /** Work per task: see {@link Work}; 0 is empty. */
  @Param("0")
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
