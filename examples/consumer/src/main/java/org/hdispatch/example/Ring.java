package org.hdispatch.example;

import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;

/** Heat spreads in a ring of 64 cells; what leaves one cell arrives in the next. */
public final class Ring {
  private record Cell(long key, double[] temperature) {} // temperature: previous and current

  private Ring() {}

  public static void main(String[] args) {
    CellGrid ring = CellGrid.of(64, 1, 1, Ends.PERIODIC);
    CellMap<Cell> cells =
        CellMap.of(ring.keys(), KeyOrder.ROW, key -> new Cell(key, new double[2]));
    cells.cellAt(0).temperature()[0] = 64;
    Scheme<Cell, Void> heat =
        Scheme.of(cells)
            .pass(
                "conduct",
                (cell, none, tick) -> {
                  int t = tick.previous();
                  double left = cells.get(ring.neighbour(cell.key(), -1, 0, 0)).temperature()[t];
                  double right = cells.get(ring.neighbour(cell.key(), 1, 0, 0)).temperature()[t];
                  double own = cell.temperature()[t];
                  cell.temperature()[tick.current()] = own + 0.25 * (left - 2 * own + right);
                })
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(heat);
      loop.run(5_000);
      loop.resetStats(); // after warm-up
      loop.run(15_000);
      double first = cells.cellAt(0).temperature()[loop.tick().previous()];
      double far = cells.cellAt(32).temperature()[loop.tick().previous()];
      System.out.printf("after %d steps: %.6f and %.6f%n", loop.tick().step(), first, far);
      System.out.println(loop.stats());
      if (Math.abs(first - 1) > 1e-6 || Math.abs(far - 1) > 1e-6) {
        throw new AssertionError("heat must have spread evenly"); // mean of 64 over 64 cells
      }
    }
  }
}
