package org.hdispatch.bench.sph;

import java.util.concurrent.TimeUnit;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.sph.SearchMode;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.SumForm;
import org.hdispatch.sph.cases.PeriodicShear;
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
 * What is a list of neighbours worth that lasts, for a step or for several, in cells of which edge
 * and under which collector?
 *
 * <p>Particles of one fluid in a periodic box, in a shear flow. Read {@code step:mpups}. (The line
 * {@code step} is steps per microsecond.)
 *
 * <p>Expected: double search pays for two searches in each step, single for one, Verlet lists for
 * one in ten steps; the shorter the cells, the cheaper a search, which looks at all particles of 27
 * cells. Collectors make no difference, as nothing is left for them.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar SphSearchBenchmark
 * java -jar jmh/target/benchmarks.jar SphSearchBenchmark -p search=VERLET -p cellEdge=0 \
 *     -p workers=1,2 -jvmArgsAppend -XX:+UseParallelGC
 * }</pre>
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Threads(1)
@Fork(value = 1, jvmArgsPrepend = "--add-modules=jdk.incubator.vector")
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class SphSearchBenchmark {
  /** Steps per call: a Verlet list lasts about as long. */
  static final int STEPS = 10;

  /** Particles, their workers running. */
  @State(Scope.Benchmark)
  public static class Box {
    /** Particles along each axis. */
    @Param("40")
    public int edge;

    /** Support radius, in distances of particles. */
    @Param("3.0")
    public double support;

    /** When neighbours are searched for. */
    @Param({"DOUBLE", "SINGLE", "VERLET"})
    public SearchMode search;

    /** Edge of a cell, in distances of particles; 0: as short as may be. */
    @Param({"0", "4.5", "6"})
    public double cellEdge;

    /** Form of the sums: FASTEST that this JVM can run, or SCALAR, VECTOR. */
    @Param("FASTEST")
    public String form;

    /** Number of workers. */
    @Param({"1", "2"})
    public int workers;

    private Dispatcher dispatcher;
    private TimeLoop loop;
    private int particles;

    /** Makes the particles and starts the workers. */
    @Setup(Level.Trial)
    public void begin() {
      PeriodicShear shear = new PeriodicShear(edge, support);
      SphSchemeBuilder settings = shear.settings().search(search);
      if (cellEdge > 0) {
        settings.cellEdge(cellEdge);
      }
      if (!form.equals("FASTEST")) {
        settings.form(SumForm.valueOf(form));
      }
      SphScheme scheme = settings.build(shear.particles());
      particles = shear.count();
      dispatcher = Dispatcher.withWorkers(workers);
      loop = dispatcher.loop(scheme);
    }

    /** Ends the workers. */
    @TearDown(Level.Trial)
    public void end() {
      dispatcher.close();
    }
  }

  /** Some steps. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public void step(Box box, ParticleRate rate) {
    box.loop.run(STEPS);
    rate.mpups += (long) STEPS * box.particles;
  }
}
