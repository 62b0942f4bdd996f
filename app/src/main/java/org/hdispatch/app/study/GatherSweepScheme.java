package org.hdispatch.app.study;

import java.util.List;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Pass;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.Tick;

/**
 * The memory traffic of an explicit method without its physics: gather a cell's previous values and
 * some of eight neighbours' into scratch, if asked for sweep over the scratch, write the cell's
 * current values.
 *
 * <p>A cell has half as many values as the scratch, twice over (previous and current), so the live
 * set is as many bytes as cells times scratch.
 */
public final class GatherSweepScheme implements Scheme<GatherSweepScheme.Cell, double[]> {
  /** The corners of a cube: the neighbours of which an eighth of the values is gathered. */
  private static final int NEIGHBOURS = 8;

  private final int scratchLength;
  private final boolean sweeps;
  private final CellMap<Cell> cells;

  /**
   * Makes the cells.
   *
   * @param edge cells along each axis of a periodic cube
   * @param scratchBytes size of one scratch
   * @param sweeps whether there is arithmetic: a recurrence over the scratch, a few nanoseconds a
   *     value, as each waits for the one before
   */
  public GatherSweepScheme(int edge, int scratchBytes, boolean sweeps) {
    scratchLength = scratchBytes / Double.BYTES;
    this.sweeps = sweeps;
    CellGrid grid = CellGrid.of(edge, edge, edge, Ends.PERIODIC);
    cells = CellMap.of(grid.keys(), KeyOrder.ROW, key -> new Cell(scratchLength / 2));
    for (int n = 0; n < cells.size(); n++) {
      cells.cellAt(n).link(grid, cells.keyAt(n), cells);
    }
  }

  /** Values of a cell, and the neighbours it gathers from. */
  public static final class Cell {
    private final double[][] values;
    private final Cell[] neighbours = new Cell[NEIGHBOURS];

    Cell(int length) {
      values = new double[2][length];
      for (int n = 0; n < length; n++) {
        values[0][n] = n % 7;
      }
    }

    void link(CellGrid grid, long key, CellMap<Cell> cells) {
      for (int corner = 0; corner < NEIGHBOURS; corner++) {
        int di = (corner & 1) * 2 - 1;
        int dj = (corner >> 1 & 1) * 2 - 1;
        int dk = (corner >> 2 & 1) * 2 - 1;
        neighbours[corner] = cells.get(grid.neighbour(key, di, dj, dk));
      }
    }

    double[] values(int buffer) {
      return values[buffer];
    }
  }

  @Override
  public CellMap<Cell> cells() {
    return cells;
  }

  @Override
  public double[] newScratch() {
    return new double[scratchLength];
  }

  @Override
  public List<Pass<Cell, double[]>> passes() {
    return List.of(new Pass<>("gather-sweep", this::process));
  }

  private void process(Cell cell, double[] scratch, Tick tick) {
    int previous = tick.previous();
    double[] own = cell.values[previous];
    int share = own.length / NEIGHBOURS;
    System.arraycopy(own, 0, scratch, 0, own.length);
    for (int n = 0; n < NEIGHBOURS; n++) {
      System.arraycopy(
          cell.neighbours[n].values[previous], 0, scratch, own.length + n * share, share);
    }
    if (sweeps) {
      double last = scratch[0];
      for (int n = 1; n < scratch.length; n++) {
        last = 0.25 * last + 0.75 * scratch[n];
        scratch[n] = last;
      }
    }
    double[] current = cell.values[tick.current()];
    for (int n = 0; n < current.length; n++) {
      current[n] = 0.5 * scratch[n] + 0.5 * scratch[n + current.length];
    }
  }
}
