package org.hdispatch.bench.dispatch;

import org.hdispatch.bench.peer.Peer;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.TearDown;

/**
 * What becomes of a step when another process takes one of the cores?
 *
 * <p>Score: ns per step of 1000 tasks of about 1 us; {@code :task} is ns per task. The other
 * process spins on core 1, where {@code taskset} can hold it there.
 *
 * <p>Expected with two workers on two cores, one of them taken: pull 1.0 to 1.4 times {@code
 * SEQUENTIAL}, least where idle workers park at once: a step ends when all cells are done, not when
 * all workers have looked in. An eager barrier (scatter) ends when the system has scheduled every
 * thread: some ms, a slice of time. Static waits likewise for the cells of the worker that lost its
 * core.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar TakenCoreBenchmark
 * }</pre>
 */
public class TakenCoreBenchmark extends Sweep {
  /** Steps per call. */
  static final int STEPS = 10;

  /** How many cores another process takes. */
  public enum Taken {
    /** None: the control. */
    NONE,
    /** One. */
    ONE
  }

  /** What sweeps the cells. */
  @Param({"PULL", "PULL_PARK", "STATIC", "SCATTER", "STREAM", "BARRIER_COUNTER", "SEQUENTIAL"})
  public Peer peer;

  /** Number of cells. */
  @Param("1000")
  public int cells;

  /** Work per task: see {@link Work}. */
  @Param("800")
  public long work;

  /** Whether a core is taken. */
  @Param({"NONE", "ONE"})
  public Taken taken;

  private Process spinner;

  /** Takes the core and starts the threads. */
  @Setup(Level.Trial)
  public void begin() {
    if (taken == Taken.ONE) {
      spinner = Spinner.start();
    }
    start(peer, cells, Work.of(CostLaw.UNIFORM, cells, work));
  }

  /** Gives the core back. */
  @TearDown(Level.Trial)
  public void release() {
    if (spinner != null) {
      spinner.destroy();
    }
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(TaskCount count, RoundTrip machine) {
    run(STEPS, count);
    machine.report();
  }
}
