package org.hdispatch.bench.peer;

import java.util.concurrent.atomic.AtomicInteger;

/** Cell numbers from one counter that all threads increment. */
final class SharedCounter implements BarrierSweeper.Supply {
  private final AtomicInteger next = new AtomicInteger();
  private final int cells;

  SharedCounter(int cells) {
    this.cells = cells;
  }

  @Override
  public void refill() {
    next.set(0);
  }

  @Override
  public int take() {
    int cell = next.getAndIncrement();
    return cell < cells ? cell : -1;
  }
}
