package org.hdispatch.bench.lbm;

import java.util.concurrent.TimeUnit;
import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.VelocitySet;
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
 * How many nodes a second does the lattice Boltzmann method update in a square duct, and which
 * bundle is best? (Leonardi et al. 2011, figure 4: 200³ nodes, bundles of side 10 to 50.)
 *
 * <p>The duct is a cube of nodes, periodic along x, walls at the ends of y and z, driven by a body
 * force. Read the line {@code step:mflups}: MLUPS, for every node is fluid. (The line {@code step}
 * is steps per microsecond.)
 *
 * <p>Expected: the memory is the limit (D3Q15 moves 360 bytes a node in two copies, D3Q19 456), so
 * D3Q19 about 0.8 of D3Q15; side 10 slowest; long in x best, for its runs are long. Side 200 needs
 * 2.5 GB of heap for D3Q15 and 3 GB for D3Q19 with {@code -XX:G1HeapRegionSize=16m}, and up to 5 GB
 * without: to G1 an array of more than half a region is humongous and takes whole regions.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar DuctBenchmark -p velocitySet=D3Q15 -p workers=2
 * java -jar jmh/target/benchmarks.jar DuctBenchmark -p side=200 -p bundle=20,200x200x10 \
 *     -jvmArgs "-Xmx5g -XX:G1HeapRegionSize=16m"
 * }</pre>
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Threads(1)
@Fork(1)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 10, time = 2)
public class DuctBenchmark {
  /** Steps per call. */
  static final int STEPS = 4;

  /** A duct, its workers running. */
  @State(Scope.Benchmark)
  public static class Running {
    /** Nodes along each axis. */
    @Param("100")
    public int side;

    /** Size of the bundles: edge of a cube, or nx, ny and nz. Cut short at the ends of the duct. */
    @Param({"10", "20", "50", "100x100x10"})
    public String bundle;

    /** The lattice's velocities. */
    @Param({"D3Q15", "D3Q19"})
    public VelocitySet velocitySet;

    /** Number of workers. */
    @Param({"1", "2"})
    public int workers;

    private LbmRun run;

    /** Makes the duct and starts the workers. */
    @Setup(Level.Trial)
    public void begin() {
      Lattice duct = Lattice.empty(side, side, side, Ends.PERIODIC, Ends.OPEN, Ends.OPEN);
      run = new LbmRun(duct, velocitySet, bundle, workers);
    }

    /** Ends the workers. */
    @TearDown(Level.Trial)
    public void end() {
      run.close();
    }
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(Running running, NodeRate rate) {
    running.run.run(STEPS, rate);
  }
}
