package org.hdispatch.bench.peer;

import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;

/** The dispatcher in the form of its peers: a scheme of one pass over a row of cells. */
public final class DispatcherSweeper implements Sweeper {
  private final Dispatcher dispatcher;
  private final TimeLoop loop;

  /** A dispatcher of these settings for cells 0 to {@code cells - 1}. */
  public DispatcherSweeper(Dispatcher.Builder settings, int cells, CellTask task) {
    CellMap<Cell> row =
        CellMap.of(
            CellGrid.of(cells, 1, 1, Ends.OPEN).keys(),
            KeyOrder.ROW,
            key -> new Cell(CellKey.i(key)));
    dispatcher = settings.build();
    loop =
        dispatcher.loop(
            Scheme.of(row).pass("task", (cell, none, tick) -> task.process(cell.number())).build());
  }

  private record Cell(int number) {}

  @Override
  public void run(int steps) {
    loop.run(steps);
  }

  @Override
  public void close() {
    dispatcher.close();
  }
}
