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
 * How many fluid nodes a second does the lattice Boltzmann method update in rock, from tight to
 * open?
 *
 * <p>The rock is a periodic cube of random overlapping spheres, driven by a body force; pores that
 * do not span the cube are computed too. Read the line {@code step:mflups}: MFLUPS. (The line
 * {@code step} is steps per microsecond.)
 *
 * <p>Expected: nearly flat. Only fluid nodes are stored, so the rate does not fall with porosity;
 * in tight rock runs of fluid are short and links are looked up one by one, but more of it fits
 * into the cache.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar RockBenchmark -p workers=2
 * }</pre>
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Threads(1)
@Fork(1)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 10, time = 2)
public class RockBenchmark {
  /** Steps per call. */
  static final int STEPS = 4;

  /** Seed of the centres: the year of the paper. */
  static final long SEED = 2011;

  /** A rock, its workers running. */
  @State(Scope.Benchmark)
  public static class Running {
    /** Nodes along each axis. */
    @Param("100")
    public int side;

    /** Radius of the spheres, in nodes. */
    @Param("10")
    public double radius;

    /** Share of fluid nodes. */
    @Param({"0.1", "0.2", "0.4", "0.8"})
    public double porosity;

    /** Size of the bundles: edge of a cube, or nx, ny and nz. */
    @Param("20")
    public String bundle;

    /** The lattice's velocities. */
    @Param("D3Q19")
    public VelocitySet velocitySet;

    /** Number of workers. */
    @Param({"1", "2"})
    public int workers;

    private LbmRun run;

    /** Makes the rock and starts the workers. */
    @Setup(Level.Trial)
    public void begin() {
      Lattice rock =
          new Lattice(
              side,
              side,
              side,
              Ends.PERIODIC,
              Ends.PERIODIC,
              Ends.PERIODIC,
              new RandomSpheres(side, radius, porosity, SEED));
      run = new LbmRun(rock, velocitySet, bundle, workers);
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
