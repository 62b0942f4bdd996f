package org.hdispatch.bench.dispatch;

import java.util.concurrent.TimeUnit;
import org.hdispatch.bench.peer.BarrierSweeper;
import org.hdispatch.bench.peer.CellTask;
import org.hdispatch.bench.peer.DispatcherSweeper;
import org.hdispatch.bench.peer.InvokeAllSweeper;
import org.hdispatch.bench.peer.SequentialSweeper;
import org.hdispatch.bench.peer.StreamSweeper;
import org.hdispatch.bench.peer.Sweeper;
import org.hdispatch.dispatch.Handout;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Threads;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.infra.Blackhole;

/**
 * What does one empty task cost, and one step of them, with the dispatcher and with its peers?
 *
 * <p>Score: ns per step; {@code :task} is ns per task; {@code sequential} is the tasks alone.
 *
 * <p>Expected with two workers on two cores at 10 000 cells: pull some 5 ns a task, static 1 to 2,
 * a parallel stream 3 to 6, barrier and shared counter 30, invokeAll 100 to 300. At 64 cells the
 * fixed cost of a step shows: pull and static 1 to 2 us, all others 5 us and more.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar EmptyTaskBenchmark -p workers=2
 * }</pre>
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Threads(1)
@Fork(3)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 10, time = 1)
public class EmptyTaskBenchmark {
  /** Steps per call, so that what a call costs once does not count. */
  static final int STEPS = 100;

  /** What is swept, by how many workers. */
  @State(Scope.Benchmark)
  public static class Load {
    /** Number of cells. */
    @Param({"64", "1000", "10000"})
    public int cells;

    /** Number of workers. */
    @Param({"1", "2"})
    public int workers;

    /** Work per task in tokens of {@code Blackhole.consumeCPU}, some 2 ns each; 0 is empty. */
    @Param("0")
    public long tokens;

    CellTask task() {
      long work = tokens;
      return work == 0 ? new EmptyTask() : cell -> Blackhole.consumeCPU(work);
    }
  }

  /** Counts tasks. */
  @State(Scope.Thread)
  @AuxCounters(AuxCounters.Type.OPERATIONS)
  public static class Count {
    /** Tasks done. */
    public long task;
  }

  /** The threads of one variant: started before the first and ended after the last iteration. */
  public abstract static class Running {
    private Sweeper sweeper;

    abstract Sweeper start(Load load);

    /** Starts the threads. */
    @Setup(Level.Trial)
    public void begin(Load load) {
      sweeper = start(load);
    }

    /** Ends the threads. */
    @TearDown(Level.Trial)
    public void end() {
      sweeper.close();
    }

    void run(Load load, Count count) {
      sweeper.run(STEPS);
      count.task += (long) STEPS * load.cells;
    }
  }

  /** The dispatcher, workers pull. */
  @State(Scope.Benchmark)
  public static class Pull extends Running {
    @Override
    Sweeper start(Load load) {
      return new DispatcherSweeper(load.workers, load.cells, Handout.PULL, load.task());
    }
  }

  /** The dispatcher, each worker gets its segment. */
  @State(Scope.Benchmark)
  public static class Static extends Running {
    @Override
    Sweeper start(Load load) {
      return new DispatcherSweeper(load.workers, load.cells, Handout.STATIC, load.task());
    }
  }

  /** Parallel stream. */
  @State(Scope.Benchmark)
  public static class Stream extends Running {
    @Override
    Sweeper start(Load load) {
      return new StreamSweeper(load.workers, load.cells, load.task());
    }
  }

  /** Executor. */
  @State(Scope.Benchmark)
  public static class InvokeAll extends Running {
    @Override
    Sweeper start(Load load) {
      return new InvokeAllSweeper(load.workers, load.cells, load.task());
    }
  }

  /** Barrier and shared counter. */
  @State(Scope.Benchmark)
  public static class Barrier extends Running {
    @Override
    Sweeper start(Load load) {
      return new BarrierSweeper(load.workers, load.cells, load.task());
    }
  }

  /** Plain loop. */
  @State(Scope.Benchmark)
  public static class Sequential extends Running {
    @Override
    Sweeper start(Load load) {
      return new SequentialSweeper(load.cells, load.task());
    }
  }

  /** The dispatcher, workers pull. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void dispatcherPull(Pull threads, Load load, Count count) {
    threads.run(load, count);
  }

  /** The dispatcher, each worker gets its segment and nothing else. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void dispatcherStatic(Static threads, Load load, Count count) {
    threads.run(load, count);
  }

  /** {@code IntStream.range(0, cells).parallel()} in a fork-join pool of its own. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void parallelStream(Stream threads, Load load, Count count) {
    threads.run(load, count);
  }

  /** {@code ExecutorService.invokeAll} with a task per cell. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void invokeAll(InvokeAll threads, Load load, Count count) {
    threads.run(load, count);
  }

  /** {@code CyclicBarrier} and a shared {@code AtomicInteger}. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void barrierAndCounter(Barrier threads, Load load, Count count) {
    threads.run(load, count);
  }

  /** A loop on the caller's thread, whatever the number of workers. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void sequential(Sequential threads, Load load, Count count) {
    threads.run(load, count);
  }
}
