package org.hdispatch.bench.lbm;

import java.lang.ref.Reference;
import java.util.concurrent.TimeUnit;
import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.NodeMap;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.pore.RandomSpheres;
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
import org.openjdk.jmh.annotations.Threads;
import org.openjdk.jmh.annotations.Warmup;

/**
 * How many fluid nodes a second does the lattice Boltzmann method update in rock, from tight to
 * open, and in which bundles?
 *
 * <p>The rock is a periodic cube of random overlapping spheres, driven by a body force; pores that
 * do not span the cube are computed too. Read {@code step:mflups}, {@code bytesPerNode} (of a fluid
 * node) and {@code ofBandwidth}. (The line {@code step} is steps per microsecond.)
 *
 * <p>Expected: only fluid nodes are stored, so the rate falls little with porosity: in tight rock
 * rows are short and more nodes go through links, which costs time and some bytes a node; but at
 * porosity 0.1 its 15 MB also fit into many a last-level cache. Large bundles are best, in tight
 * rock too: fewer links lead from one to another.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar RockBenchmark
 * java -jar jmh/target/benchmarks.jar RockBenchmark -p bundle=32x8x8 \
 *     -p streaming=IN_PLACE,PULL,PUSH -p storage=DOUBLE,SINGLE
 * }</pre>
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Threads(1)
@Fork(value = 1, jvmArgsPrepend = "--add-modules=jdk.incubator.vector")
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class RockBenchmark {
  /** Steps per call. */
  static final int STEPS = 4;

  /** Seed of the centres: the year of the paper. */
  static final long SEED = 2011;

  /** A rock, its workers running. */
  @State(Scope.Benchmark)
  public static class Rock extends LbmRun {
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
    @Param({"10", "20", "32x8x8", "50", "100x10x10"})
    public String bundle;

    /** The lattice's velocities. */
    @Param("D3Q19")
    public VelocitySet velocitySet;

    /** Makes the rock and starts the workers. */
    @Setup(Level.Trial)
    public void begin() {
      NodeMap spheres = new RandomSpheres(radius, SEED).poreSpace(side, porosity)::isPore;
      Ends ends = Ends.PERIODIC;
      start(new Lattice(side, side, side, ends, ends, ends, spheres), velocitySet, bundle);
      Reference.reachabilityFence(spheres); // the rock is no part of what the scheme holds
    }
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(Rock rock, NodeRate rate, Memory memory, Bandwidth bandwidth) {
    rock.run(STEPS, rate, bandwidth);
    rock.report(memory);
  }
}
