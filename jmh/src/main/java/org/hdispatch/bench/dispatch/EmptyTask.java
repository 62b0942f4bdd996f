package org.hdispatch.bench.dispatch;

import org.hdispatch.bench.peer.CellTask;

/**
 * Next to nothing: a volatile read and a comparison that never holds. Everything may inline it, and
 * no compiler may leave it out.
 */
final class EmptyTask implements CellTask {
  private volatile int never = -1;

  @Override
  public void process(int cell) {
    if (cell == never) {
      never = cell - 1;
    }
  }
}
