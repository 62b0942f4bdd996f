package org.hdispatch.bench.peer;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.Ends;

/** Cell keys from a queue without locks. Every step boxes each key and makes its node anew. */
final class QueueOfKeys implements BarrierSweeper.Supply {
  private final Queue<Long> queue = new ConcurrentLinkedQueue<>();
  private final long[] keys;

  QueueOfKeys(int cells) {
    keys = CellGrid.of(cells, 1, 1, Ends.OPEN).keys();
  }

  @Override
  public void refill() {
    for (long key : keys) {
      queue.add(key);
    }
  }

  @Override
  public int take() {
    Long key = queue.poll();
    return key == null ? -1 : CellKey.i(key);
  }
}
