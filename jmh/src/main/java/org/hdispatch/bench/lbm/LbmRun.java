package org.hdispatch.bench.lbm;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;

/** A lattice driven by a body force along x, TRT at tau 1, its workers running. */
@State(Scope.Benchmark)
public abstract class LbmRun {
  /** Weak: the flow stays slow however long the benchmark runs. */
  private static final BodyForce FORCE = new BodyForce(1e-7, 0, 0);

  /** How populations move: IN_PLACE, PULL, PUSH. */
  @Param("IN_PLACE")
  public Streaming streaming;

  /** Precision in which populations are stored: DOUBLE, SINGLE. */
  @Param("DOUBLE")
  public Storage storage;

  /** Form of the kernel: FASTEST that this JVM can run, or REFERENCE, SCALAR, VECTOR. */
  @Param(Kernels.FASTEST)
  public String kernel;

  /** Number of workers. */
  @Param("2")
  public int workers;

  private Held<LbmScheme> scheme;
  private double bytesMoved; // a node and step
  private Dispatcher dispatcher;
  private TimeLoop loop;
  private StreamProbe probe;
  private double bandwidth;
  private double updates; // in this iteration
  private long nanos;

  /** Makes the nodes and starts the workers: in the set-up of a trial. */
  final void start(Lattice lattice, VelocitySet set, String bundle) {
    scheme =
        Held.measure(
            () ->
                LbmScheme.on(lattice)
                    .velocitySet(set)
                    .bundleSize(BundleSizes.parse(bundle))
                    .streaming(streaming)
                    .storage(storage)
                    .kernel(Kernels.parse(kernel))
                    .force(FORCE)
                    .build());
    bytesMoved = (streaming.copies() + 1.0) * set.size() * storage.bytes();
    dispatcher = Dispatcher.withWorkers(workers);
    loop = dispatcher.loop(scheme.made());
    probe = new StreamProbe(dispatcher, streaming);
  }

  /** Measures the bandwidth. */
  @Setup(Level.Iteration)
  public void measureBandwidth() {
    bandwidth = probe.measure();
    updates = 0;
    nanos = 0;
  }

  /** Runs this many steps. */
  final void run(int steps, NodeRate rate, Bandwidth use) {
    long begin = System.nanoTime();
    loop.run(steps);
    nanos += System.nanoTime() - begin;
    long nodes = scheme.made().nodes();
    rate.mflups += steps * nodes;
    updates += (double) steps * nodes;
    use.bandwidthGBps = bandwidth;
    use.ofBandwidth = updates * bytesMoved / nanos / bandwidth;
  }

  /** Puts the figure where JMH reads it, for it clears the counters before each iteration. */
  final void report(Memory memory) {
    memory.bytesPerNode = (double) scheme.bytes() / scheme.made().nodes();
  }

  /** Ends the workers. */
  @TearDown(Level.Trial)
  public void end() {
    dispatcher.close();
  }
}
