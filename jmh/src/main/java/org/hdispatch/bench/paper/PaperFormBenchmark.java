package org.hdispatch.bench.paper;

import java.util.concurrent.TimeUnit;
import org.hdispatch.bench.lbm.BundleSizes;
import org.hdispatch.bench.lbm.Ducts;
import org.hdispatch.bench.lbm.Held;
import org.hdispatch.bench.lbm.Kernels;
import org.hdispatch.bench.lbm.Memory;
import org.hdispatch.bench.lbm.NodeRate;
import org.hdispatch.dispatch.Scheme;
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
 * What is a flat layout worth beside the paper's own, a dictionary of bundles which are
 * dictionaries of nodes: in nodes per second, bytes per node, and garbage?
 *
 * <p>All forms compute the same flow in the same duct on the same workers, bit by bit but for
 * single precision. Read {@code step:mflups} (MLUPS, for every node is fluid), {@code
 * bytesPerNode}, and with {@code -prof gc} {@code gc.alloc.rate.norm}, bytes per step of all
 * threads, and {@code gc.count} and {@code gc.time} of all iterations.
 *
 * <p>Expected with two workers: dictionaries 2 MLUPS, for a node looks up 14 neighbours, and each
 * key is boxed for that: 350 bytes a node and step for the collector, which frees them cheaply, for
 * all are dead. Populations that are objects too: three times slower, 2.5 times the memory, and the
 * collector has work. Keys that are numbers: no garbage, 1.5 times as fast. Flat bundles, still
 * node by node: 4 times as fast as dictionaries; by vectors 15 times; in place 30 times and more.
 * Push like pull. Bytes of a node: 380 in dictionaries, 990 with boxed populations, 255 in two flat
 * copies, 130 in one, 70 in single precision.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar PaperFormBenchmark -prof gc
 * java -jar jmh/target/benchmarks.jar PaperFormBenchmark -prof gc -p form=NODES_BOXED,NODES_PULL \
 *     -jvmArgsAppend -XX:+UseParallelGC
 * }</pre>
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Threads(1)
@Fork(
    value = 1,
    jvmArgsPrepend = "--add-modules=jdk.incubator.vector",
    jvmArgs = {"-Xms3g", "-Xmx3g"})
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class PaperFormBenchmark {
  /** Steps per call. */
  static final int STEPS = 2;

  /** A duct, its workers running. */
  @State(Scope.Benchmark)
  public static class Running {
    /** How nodes are stored and streamed. */
    @Param public PaperForm form;

    /** Nodes along each axis. */
    @Param("80")
    public int side;

    /** Size of the bundles: edge of a cube, or nx, ny and nz. The paper's best is 20. */
    @Param("20")
    public String bundle;

    /** The lattice's velocities: the paper's. */
    @Param("D3Q15")
    public VelocitySet velocitySet;

    /**
     * Kernel of the flat forms but FLAT_REFERENCE: FASTEST that this JVM can run, SCALAR, VECTOR.
     */
    @Param(Kernels.FASTEST)
    public String kernel;

    /** Number of workers. */
    @Param("2")
    public int workers;

    private Held<Scheme<?, ?>> scheme;
    private Stepper stepper;

    /** Makes the duct and starts the workers. */
    @Setup(Level.Trial)
    public void begin() {
      scheme =
          Held.measure(
              () ->
                  form.scheme(
                      Ducts.square(side),
                      velocitySet,
                      BundleSizes.parse(bundle),
                      Kernels.parse(kernel)));
      stepper = form.start(scheme.made(), workers);
    }

    /** Ends the workers. */
    @TearDown(Level.Trial)
    public void end() {
      stepper.close();
    }
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(Running running, NodeRate rate, Memory memory) {
    long nodes = (long) running.side * running.side * running.side;
    running.stepper.run(STEPS);
    rate.mflups += STEPS * nodes;
    memory.bytesPerNode = (double) running.scheme.bytes() / nodes;
  }
}
