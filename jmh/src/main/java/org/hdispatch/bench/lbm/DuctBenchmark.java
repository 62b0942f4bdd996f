package org.hdispatch.bench.lbm;

import java.util.concurrent.TimeUnit;
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
import org.openjdk.jmh.annotations.Threads;
import org.openjdk.jmh.annotations.Warmup;

/**
 * How many nodes a second does the lattice Boltzmann method update in a square duct: with which
 * bundle, streaming, storage, kernel, and number of workers? (Leonardi et al. 2011, figure 4: 200³
 * nodes, bundles of side 10 to 50.)
 *
 * <p>The duct is a cube of nodes, periodic along x, walls at the ends of y and z, driven by a body
 * force. Read {@code step:mflups} (MLUPS, for every node is fluid), {@code bytesPerNode} and {@code
 * ofBandwidth}. (The line {@code step} is steps per microsecond.)
 *
 * <p>Expected: in place moves 2 Q numbers a node and holds Q, pull and push move 3 Q and hold 2 Q:
 * in place 1.5 to 2 times as fast, and half the memory; push like pull; D3Q19 0.8 of D3Q15. Side 10
 * slowest, long in x best, for its rows are long. With vector kernels the memory is the limit in
 * double precision; single precision gains memory only, for it is computed in double and the change
 * costs more than it saves. Loops come to a fourth of the bandwidth: computing is their limit. The
 * reference last, for it computes node by node.
 *
 * <p>Side 200, D3Q15, double holds 1 GB in place and 2 GB otherwise; give 3 GB more than that. To
 * G1 an array of more than half a region is humongous and takes whole regions: {@code
 * -XX:G1HeapRegionSize=16m} for large bundles. The collector is not a parameter here, for it is one
 * of the JVM: {@link CollectorBenchmark}.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar DuctBenchmark
 * java -jar jmh/target/benchmarks.jar DuctBenchmark -p bundle=32x8x8 -p velocitySet=D3Q15 \
 *     -p streaming=IN_PLACE,PULL,PUSH -p storage=DOUBLE,SINGLE -p kernel=SCALAR,REFERENCE
 * java -jar jmh/target/benchmarks.jar DuctBenchmark -p side=200 -p velocitySet=D3Q15 \
 *     -p bundle=10,20,32x8x8,50,200x200x10 -jvmArgs "-Xmx5g -XX:G1HeapRegionSize=16m"
 * }</pre>
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Threads(1)
@Fork(value = 1, jvmArgsPrepend = "--add-modules=jdk.incubator.vector")
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class DuctBenchmark {
  /** Steps per call. */
  static final int STEPS = 4;

  /** A duct, its workers running. */
  @State(Scope.Benchmark)
  public static class Duct extends LbmRun {
    /** Nodes along each axis. */
    @Param("100")
    public int side;

    /** Size of the bundles: edge of a cube, or nx, ny and nz. Cut short at the ends of the duct. */
    @Param({"10", "20", "32x8x8", "50", "100x100x10"})
    public String bundle;

    /** The lattice's velocities. */
    @Param({"D3Q15", "D3Q19"})
    public VelocitySet velocitySet;

    /** Makes the duct and starts the workers. */
    @Setup(Level.Trial)
    public void begin() {
      start(Ducts.square(side), velocitySet, bundle);
    }
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(Duct duct, NodeRate rate, Memory memory, Bandwidth bandwidth) {
    duct.run(STEPS, rate, bandwidth);
    duct.report(memory);
  }
}
