package org.hdispatch.bench.gc;

import java.util.concurrent.TimeUnit;
import org.hdispatch.app.study.GatherSweepScheme;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.ScratchLifetime;
import org.hdispatch.dispatch.TimeLoop;
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

/**
 * What is it worth that every worker keeps its scratch, instead of making it anew for each step or
 * each cell?
 *
 * <p>Score: us per step of 1000 cells; {@code :cell} is us per cell; with {@code -prof gc}, {@code
 * gc.alloc.rate.norm} is bytes per step of all threads. The heap is fixed at 384 MB, six times the
 * live set at 64 KiB of scratch; give other sizes and collectors through {@code -jvmArgs}.
 *
 * <p>Expected: enduring and per step alike, and 0 collections for enduring; per cell 1.3 to 1.7
 * times as slow at 64 KiB (less at 4 KiB, where the scratch stays in the cache), most of it not
 * collection but the zeroing of memory and its way through the cache. Enduring scratch allocates
 * nothing; what {@code -prof gc} shows for it, some bytes per step, is the harness.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar ScratchLifetimeBenchmark -prof gc
 * java -jar jmh/target/benchmarks.jar ScratchLifetimeBenchmark -prof gc \
 *     -jvmArgs "-Xms128m -Xmx128m -XX:+UseParallelGC"
 * }</pre>
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Threads(1)
@Fork(
    value = 3,
    jvmArgs = {"-Xms384m", "-Xmx384m"})
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 10, time = 1)
public class ScratchLifetimeBenchmark {
  /** Steps per call. */
  static final int STEPS = 10;

  /** Cells along each axis. */
  static final int EDGE = 10;

  /** A loop over a scheme, its workers running. */
  @State(Scope.Benchmark)
  public static class Running {
    /** How long a scratch lives. */
    @Param({"ENDURING", "PER_STEP", "PER_CELL"})
    public ScratchLifetime lifetime;

    /** Size of a scratch. */
    @Param({"4096", "65536"})
    public int scratchBytes;

    /** Number of workers. */
    @Param("2")
    public int workers;

    private Dispatcher dispatcher;
    private TimeLoop loop;

    /** Makes the cells and starts the workers. */
    @Setup(Level.Trial)
    public void begin() {
      dispatcher = Dispatcher.withWorkers(workers);
      loop = dispatcher.loop(new GatherSweepScheme(EDGE, scratchBytes, false), lifetime);
    }

    /** Ends the workers. */
    @TearDown(Level.Trial)
    public void end() {
      dispatcher.close();
    }
  }

  /** Counts cells. */
  @State(Scope.Thread)
  @AuxCounters(AuxCounters.Type.OPERATIONS)
  public static class Count {
    /** Cells processed. */
    public long cell;
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(Running running, Count count) {
    running.loop.run(STEPS);
    count.cell += (long) STEPS * EDGE * EDGE * EDGE;
  }
}
