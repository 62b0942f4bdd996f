package org.hdispatch.bench.dispatch;

import org.hdispatch.bench.peer.CellTask;

/**
 * So many multiplications and additions, each waiting for the one before, and one store: 4 cycles
 * per unit of work on most processors. The peer in C does the same.
 */
final class Work implements CellTask {
  private final long[] work;
  private final long[] sums;

  // Not constants: with those JDK 25 unrolls the chain and folds many steps of it into one.
  private final long factor = Long.parseLong("6364136223846793005");
  private final long summand = Long.parseLong("1442695040888963407");

  private Work(long[] work) {
    this.work = work;
    sums = new long[work.length];
  }

  /**
   * A task for so many cells.
   *
   * @param law how the work is spread
   * @param cells their number
   * @param meanWork mean work of a cell; 0 is {@link EmptyTask}
   */
  static CellTask of(CostLaw law, int cells, long meanWork) {
    return meanWork == 0 ? new EmptyTask() : new Work(law.work(cells, meanWork));
  }

  @Override
  public void process(int cell) {
    long x = cell;
    for (long n = work[cell]; n > 0; n--) {
      x = x * factor + summand;
    }
    sums[cell] = x;
  }
}
