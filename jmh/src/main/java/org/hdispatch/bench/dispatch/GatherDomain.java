package org.hdispatch.bench.dispatch;

import java.util.Arrays;
import java.util.Collections;
import java.util.Random;
import org.hdispatch.bench.peer.CellTask;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;

/**
 * A periodic cube of cells of 2 KiB, twice over (previous and current). The task of a cell is the
 * memory traffic of an explicit method: its current values become the mean of its own previous
 * values and those of its 26 neighbours.
 */
final class GatherDomain implements CellTask {
  /** Values of a cell: 2 KiB. */
  private static final int LENGTH = 256;

  private static final int NEIGHBOURHOOD = 27;

  private final Cell[] cells;
  private int previous;

  /** A cell's values, and whose it reads. */
  private static final class Cell {
    final double[][] values = new double[2][LENGTH];
    final Cell[] neighbourhood = new Cell[NEIGHBOURHOOD];
  }

  /** A cube with so many cells along each axis. */
  GatherDomain(int edge, GatherOrder order) {
    CellGrid grid = CellGrid.of(edge, edge, edge, Ends.PERIODIC);
    CellMap<Cell> map =
        CellMap.of(
            grid.keys(),
            order == GatherOrder.MORTON ? KeyOrder.MORTON : KeyOrder.ROW,
            key -> new Cell());
    cells = new Cell[map.size()];
    for (int n = 0; n < cells.length; n++) {
      cells[n] = map.cellAt(n);
      Arrays.fill(cells[n].values[0], n % 7);
      link(cells[n], map, grid, map.keyAt(n));
    }
    if (order == GatherOrder.RANDOM) {
      Collections.shuffle(Arrays.asList(cells), new Random(2011));
    }
  }

  private static void link(Cell cell, CellMap<Cell> map, CellGrid grid, long key) {
    for (int n = 0; n < NEIGHBOURHOOD; n++) {
      cell.neighbourhood[n] = map.get(grid.neighbour(key, n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
    }
  }

  /** Number of cells. */
  int size() {
    return cells.length;
  }

  /** Makes the current values the previous ones: between two steps. */
  void flip() {
    previous ^= 1;
  }

  @Override
  public void process(int number) {
    Cell cell = cells[number];
    double[] current = cell.values[previous ^ 1];
    Arrays.fill(current, 0);
    for (Cell from : cell.neighbourhood) {
      double[] values = from.values[previous];
      for (int n = 0; n < LENGTH; n++) {
        current[n] += values[n];
      }
    }
    for (int n = 0; n < LENGTH; n++) {
      current[n] *= 1.0 / NEIGHBOURHOOD;
    }
  }
}
