package org.hdispatch.bench.gc;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Pass;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.Tick;
import org.hdispatch.dispatch.TimeLoop;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Threads;
import org.openjdk.jmh.annotations.Warmup;

/**
 * What does it cost to roll previous and current values by swapping references in old objects,
 * instead of by an index?
 *
 * <p>A store of a reference into an old object marks the card of 512 bytes that the object lies in,
 * for the collector to look at. Marks of 64 cards share a cache line, so that workers that write to
 * objects within 32 KiB of each other send the line to and fro, however far apart their values lie.
 * Here the objects that two workers roll lie between each other, on purpose: the worst case.
 *
 * <p>Score: ns of wall time per object rolled, by two workers; a step rolls 16384 objects. Nothing
 * is allocated.
 *
 * <p>Expected: under Parallel, which marks at every store, references several times as slow as the
 * index; with {@code -XX:+UseCondCardMark}, which looks first whether the card is marked, not much
 * slower than the index; under G1 in between, for its barrier looks first whether the two objects
 * lie in the same region. Seen, in a short run on two cores, its readings half their mean apart:
 * 1.8 times the index, 1.6 with the look before, 2.3 under G1, whose barrier does more than mark.
 * So references cost more than the index; sharing of cards could not be told from the rest: more
 * workers would show it, if anything.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar ReferenceStoreBenchmark
 * }</pre>
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Threads(1)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class ReferenceStoreBenchmark {
  private static final int WORKERS = 2;
  private static final int EDGE = 4;
  private static final int CELLS = EDGE * EDGE * EDGE;
  private static final int OBJECTS = 16_384;

  /** Steps per call. */
  static final int STEPS = 10;

  /** Objects rolled per call. */
  static final int ROLLED = STEPS * OBJECTS;

  /** Something with previous and current values. */
  static final class Rolling {
    private double[] previous = new double[1];
    private double[] current = new double[1];
    private int index;

    void swap() {
      double[] next = previous;
      previous = current;
      current = next;
    }

    void turn() {
      index ^= 1;
    }
  }

  /** How one cell's objects are rolled. */
  private interface Roll {
    void roll(Rolling[] objects);
  }

  private static void swap(Rolling[] objects) {
    for (Rolling each : objects) {
      each.swap();
    }
  }

  private static void turn(Rolling[] objects) {
    for (Rolling each : objects) {
      each.turn();
    }
  }

  /** Rolls the objects of each cell. */
  private record RollScheme(CellMap<Rolling[]> cells, Roll roll)
      implements Scheme<Rolling[], Object> {
    /** Every 64th object belongs to the same cell. */
    static RollScheme of(Roll roll) {
      Rolling[] all = new Rolling[OBJECTS];
      for (int n = 0; n < OBJECTS; n++) {
        all[n] = new Rolling();
      }
      CellGrid grid = CellGrid.of(EDGE, EDGE, EDGE, Ends.OPEN);
      CellMap<Rolling[]> cells =
          CellMap.of(grid.keys(), KeyOrder.ROW, key -> new Rolling[OBJECTS / CELLS]);
      for (int n = 0; n < OBJECTS; n++) {
        cells.cellAt(n % CELLS)[n / CELLS] = all[n];
      }
      return new RollScheme(cells, roll);
    }

    @Override
    public Object newScratch() {
      return this;
    }

    @Override
    public List<Pass<Rolling[], Object>> passes() {
      return List.of(new Pass<>("roll", this::roll));
    }

    private void roll(Rolling[] objects, Object scratch, Tick tick) {
      roll.roll(objects);
    }
  }

  /** Both ways, their workers running. */
  @State(Scope.Benchmark)
  public static class Running {
    private Dispatcher dispatcher;
    private TimeLoop swapping;
    private TimeLoop turning;

    /** Makes the objects, and old. */
    @Setup(Level.Trial)
    public void begin() {
      dispatcher = Dispatcher.withWorkers(WORKERS);
      swapping = dispatcher.loop(RollScheme.of(ReferenceStoreBenchmark::swap));
      turning = dispatcher.loop(RollScheme.of(ReferenceStoreBenchmark::turn));
      System.gc();
    }

    /** Ends the workers. */
    @TearDown(Level.Trial)
    public void end() {
      dispatcher.close();
    }
  }

  /** By an index, under Parallel. */
  @Benchmark
  @Fork(
      value = 3,
      jvmArgs = {"-Xms256m", "-Xmx256m"},
      jvmArgsAppend = "-XX:+UseParallelGC")
  @OperationsPerInvocation(ROLLED)
  public void index(Running running) {
    running.turning.run(STEPS);
  }

  /** By references, under Parallel. */
  @Benchmark
  @Fork(
      value = 3,
      jvmArgs = {"-Xms256m", "-Xmx256m"},
      jvmArgsAppend = "-XX:+UseParallelGC")
  @OperationsPerInvocation(ROLLED)
  public void references(Running running) {
    running.swapping.run(STEPS);
  }

  /** By references, under Parallel, cards looked at before they are marked. */
  @Benchmark
  @Fork(
      value = 3,
      jvmArgs = {"-Xms256m", "-Xmx256m"},
      jvmArgsAppend = {"-XX:+UseParallelGC", "-XX:+UseCondCardMark"})
  @OperationsPerInvocation(ROLLED)
  public void referencesCondCardMark(Running running) {
    running.swapping.run(STEPS);
  }

  /** By references, under G1. */
  @Benchmark
  @Fork(
      value = 3,
      jvmArgs = {"-Xms256m", "-Xmx256m"},
      jvmArgsAppend = "-XX:+UseG1GC")
  @OperationsPerInvocation(ROLLED)
  public void referencesG1(Running running) {
    running.swapping.run(STEPS);
  }
}
