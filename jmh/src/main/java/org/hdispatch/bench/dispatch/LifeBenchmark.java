package org.hdispatch.bench.dispatch;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.hdispatch.bench.peer.CellTask;
import org.hdispatch.bench.peer.DispatcherSweeper;
import org.hdispatch.bench.peer.Sweeper;
import org.hdispatch.dispatch.Dispatcher;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Threads;
import org.openjdk.jmh.annotations.Warmup;

/**
 * How long do starting and closing a dispatcher take?
 *
 * <p>Score: ms. {@code start} ends when every worker has made its scratch; {@code closeIdle} finds
 * the workers parked; {@code closeRunning} is called while another thread steps a loop of 1000
 * tasks of 50 us, and ends when that thread has left its run.
 *
 * <p>Expected: all below 1 ms, and no single one above 100 ms (the reading {@code p1.00}).
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar LifeBenchmark
 * }</pre>
 */
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Threads(1)
@Fork(2)
@Warmup(iterations = 50)
@Measurement(iterations = 100)
public class LifeBenchmark {
  private static final int CELLS = 1000;

  /** A dispatcher of its own for each reading. */
  @State(Scope.Benchmark)
  public static class Life {
    /** Number of workers, the caller's thread included. */
    @Param("2")
    public int workers;

    private CellTask task;
    Sweeper sweeper;

    /** Makes the task. */
    @Setup(Level.Trial)
    public void makeTask() {
      task = Work.of(CostLaw.UNIFORM, CELLS, 40_000);
    }

    void start() {
      sweeper = new DispatcherSweeper(Dispatcher.builder().workers(workers), CELLS, task);
    }

    /** Ends what is still there. */
    @TearDown(Level.Invocation)
    public void end() {
      sweeper.close();
    }
  }

  /** A dispatcher whose workers have nothing to do. */
  public static class Idle extends Life {
    /** Starts it and lets its workers go to sleep. */
    @Setup(Level.Invocation)
    public void settle() throws InterruptedException {
      start();
      Thread.sleep(5);
    }
  }

  /** A dispatcher that another thread keeps busy. */
  public static class Running extends Life {
    private Thread stepping;

    /** Starts it and waits until the loop is under way. */
    @Setup(Level.Invocation)
    public void step() throws InterruptedException {
      start();
      CountDownLatch warm = new CountDownLatch(1);
      stepping =
          new Thread(
              () -> {
                sweeper.run(1);
                warm.countDown();
                try {
                  sweeper.run(Integer.MAX_VALUE);
                } catch (CancellationException closed) {
                  // what the benchmark does
                }
              });
      stepping.start();
      warm.await();
      Thread.sleep(5);
    }

    /** Waits for the thread. */
    @TearDown(Level.Invocation)
    public void join() throws InterruptedException {
      stepping.join();
    }
  }

  /** Starts a dispatcher and a loop. */
  @Benchmark
  public void start(Life life) {
    life.start();
  }

  /** Closes a dispatcher whose workers are parked. */
  @Benchmark
  public void closeIdle(Idle life) {
    life.sweeper.close();
  }

  /** Closes a dispatcher in the middle of a step. */
  @Benchmark
  public void closeRunning(Running life) {
    life.sweeper.close();
  }
}
