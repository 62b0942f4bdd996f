package org.hdispatch.bench.gc;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
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
import org.openjdk.jmh.annotations.Threads;
import org.openjdk.jmh.annotations.Warmup;

/**
 * What does it cost to look cells up by boxed keys, {@code HashMap<Long, Cell>}, instead of plain
 * numbers, and instead of not looking them up at all?
 *
 * <p>All 27 neighbours of each of 1000 cells are found, and a number of each is added up. Score: ns
 * per neighbour; with {@code -prof gc}, {@code gc.alloc.rate.norm} is bytes per neighbour.
 *
 * <p>Expected: boxed 24 bytes a look-up, a {@code Long} each, as C2 does not see through the map to
 * remove it; primitive and linked 0; boxed up to twice as slow as primitive; linked (neighbours
 * found once, as this library's schemes do) several times as fast as both. Next to a cell's work
 * none of them is much: what is left of boxed keys is garbage in proportion to the cells. Seen, in
 * a short run: 24 bytes, 0 and 0; 7.2, 5.9 and 0.9 ns, so boxed 1.2 times primitive.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar KeyLookUpBenchmark -prof gc
 * }</pre>
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Threads(1)
@Fork(
    value = 3,
    jvmArgs = {"-Xms256m", "-Xmx256m"})
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class KeyLookUpBenchmark {
  private static final int EDGE = 10;
  private static final int NEIGHBOURS = 27;

  /** Neighbours found per call. */
  static final int FOUND = EDGE * EDGE * EDGE * NEIGHBOURS;

  /** The cells, and the keys of each one's neighbours. */
  @State(Scope.Benchmark)
  public static class Cells {
    private final Map<Long, Cell> boxed = new HashMap<>();
    private CellMap<Cell> primitive;
    private long[] neighbourKeys;

    /** A cell: a number, and its neighbours. */
    static final class Cell {
      private final double value;
      private final Cell[] neighbours = new Cell[NEIGHBOURS];

      Cell(double value) {
        this.value = value;
      }
    }

    /** Makes them. */
    @Setup(Level.Trial)
    public void begin() {
      CellGrid grid = CellGrid.of(EDGE, EDGE, EDGE, Ends.PERIODIC);
      primitive = CellMap.of(grid.keys(), KeyOrder.ROW, Cell::new);
      neighbourKeys = new long[FOUND];
      for (int n = 0; n < primitive.size(); n++) {
        long key = primitive.keyAt(n);
        boxed.put(key, primitive.cellAt(n));
        for (int m = 0; m < NEIGHBOURS; m++) {
          long neighbour = grid.neighbour(key, m % 3 - 1, m / 3 % 3 - 1, m / 9 - 1);
          neighbourKeys[n * NEIGHBOURS + m] = neighbour;
          primitive.cellAt(n).neighbours[m] = primitive.get(neighbour);
        }
      }
    }
  }

  /** Keys boxed. */
  @Benchmark
  @OperationsPerInvocation(FOUND)
  public double boxed(Cells cells) {
    double sum = 0;
    for (long key : cells.neighbourKeys) {
      sum += cells.boxed.get(key).value;
    }
    return sum;
  }

  /** Keys as they are. */
  @Benchmark
  @OperationsPerInvocation(FOUND)
  public double primitive(Cells cells) {
    double sum = 0;
    for (long key : cells.neighbourKeys) {
      sum += cells.primitive.get(key).value;
    }
    return sum;
  }

  /** No keys: neighbours were found before. */
  @Benchmark
  @OperationsPerInvocation(FOUND)
  public double linked(Cells cells) {
    double sum = 0;
    for (int n = 0; n < cells.primitive.size(); n++) {
      for (Cells.Cell neighbour : cells.primitive.cellAt(n).neighbours) {
        sum += neighbour.value;
      }
    }
    return sum;
  }
}
