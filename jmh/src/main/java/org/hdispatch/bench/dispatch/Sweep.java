package org.hdispatch.bench.dispatch;

import java.util.concurrent.TimeUnit;
import org.hdispatch.bench.peer.CellTask;
import org.hdispatch.bench.peer.Peer;
import org.hdispatch.bench.peer.Sweeper;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Threads;
import org.openjdk.jmh.annotations.Warmup;

/**
 * A benchmark of steps. Its threads are started before the first and ended after the last
 * iteration.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Threads(1)
@Fork(2)
@Warmup(iterations = 1, time = 1)
@Measurement(iterations = 3, time = 500, timeUnit = TimeUnit.MILLISECONDS)
public abstract class Sweep {
  /** Number of workers, the caller's thread included. */
  @Param("2")
  public int workers;

  private Sweeper sweeper;
  private int cells;

  /** Starts the threads: in the set-up of a trial. */
  final void start(Peer peer, int numberOfCells, CellTask task) {
    sweeper = peer.start(workers, numberOfCells, task);
    cells = numberOfCells;
  }

  /** Ends the threads. */
  @TearDown(Level.Trial)
  public void end() {
    sweeper.close();
  }

  /** Runs this many steps. */
  final void run(int steps, TaskCount count) {
    sweeper.run(steps);
    count.task += (long) steps * cells;
  }
}
