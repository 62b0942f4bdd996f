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
 * Does it matter to the nodes per second which collector the JVM uses?
 *
 * <p>A collector belongs to the JVM, so each has a method with a fork of its own, all in one run
 * and one file. The heap is 2 GB everywhere. Read {@code :mflups}; {@code -prof gc} shows how often
 * each collects ({@code gc.count}). Bytes per node are not reported: Epsilon cannot tell them.
 *
 * <p>Expected: no. Stepping allocates nothing, so there is nothing to collect, and it stores
 * numbers, no references, so no collector has its barrier in the loop. Epsilon, which never
 * collects, is the proof.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar CollectorBenchmark -prof gc
 * }</pre>
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Threads(1)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class CollectorBenchmark {
  /** Steps per call. */
  static final int STEPS = 4;

  private static final String VECTOR = "--add-modules=jdk.incubator.vector";

  /** A duct, its workers running. */
  @State(Scope.Benchmark)
  public static class Duct extends LbmRun {
    /** Nodes along each axis. */
    @Param("100")
    public int side;

    /** Size of the bundles: edge of a cube, or nx, ny and nz. */
    @Param("32x8x8")
    public String bundle;

    /** The lattice's velocities. */
    @Param("D3Q15")
    public VelocitySet velocitySet;

    /** Makes the duct and starts the workers. */
    @Setup(Level.Trial)
    public void begin() {
      start(Ducts.square(side), velocitySet, bundle);
    }
  }

  /** Serial. */
  @Benchmark
  @Fork(
      value = 1,
      jvmArgsPrepend = VECTOR,
      jvmArgs = {"-Xms2g", "-Xmx2g"},
      jvmArgsAppend = {"-XX:+UseSerialGC"})
  @OperationsPerInvocation(STEPS)
  public void serial(Duct duct, NodeRate rate, Bandwidth bandwidth) {
    duct.run(STEPS, rate, bandwidth);
  }

  /** Parallel. */
  @Benchmark
  @Fork(
      value = 1,
      jvmArgsPrepend = VECTOR,
      jvmArgs = {"-Xms2g", "-Xmx2g"},
      jvmArgsAppend = {"-XX:+UseParallelGC"})
  @OperationsPerInvocation(STEPS)
  public void parallel(Duct duct, NodeRate rate, Bandwidth bandwidth) {
    duct.run(STEPS, rate, bandwidth);
  }

  /** G1. */
  @Benchmark
  @Fork(
      value = 1,
      jvmArgsPrepend = VECTOR,
      jvmArgs = {"-Xms2g", "-Xmx2g"},
      jvmArgsAppend = {"-XX:+UseG1GC"})
  @OperationsPerInvocation(STEPS)
  public void g1(Duct duct, NodeRate rate, Bandwidth bandwidth) {
    duct.run(STEPS, rate, bandwidth);
  }

  /** ZGC. */
  @Benchmark
  @Fork(
      value = 1,
      jvmArgsPrepend = VECTOR,
      jvmArgs = {"-Xms2g", "-Xmx2g"},
      jvmArgsAppend = {"-XX:+UseZGC"})
  @OperationsPerInvocation(STEPS)
  public void zgc(Duct duct, NodeRate rate, Bandwidth bandwidth) {
    duct.run(STEPS, rate, bandwidth);
  }

  /** Epsilon: no collector. */
  @Benchmark
  @Fork(
      value = 1,
      jvmArgsPrepend = VECTOR,
      jvmArgs = {"-Xms2g", "-Xmx2g"},
      jvmArgsAppend = {"-XX:+UnlockExperimentalVMOptions", "-XX:+UseEpsilonGC"})
  @OperationsPerInvocation(STEPS)
  public void epsilon(Duct duct, NodeRate rate, Bandwidth bandwidth) {
    duct.run(STEPS, rate, bandwidth);
  }
}
