package org.hdispatch.dispatch;

import java.util.concurrent.TimeUnit;

/**
 * A wait that ends: what takes longer than 10 s is lost, not late. jcstress would wait without end
 * for an actor that hangs while it sizes up a test.
 */
final class Patience {
  // Shorter after the first loss: the run has failed then, and should end soon.
  private static volatile long nanos = TimeUnit.SECONDS.toNanos(10);

  private final long begin = System.nanoTime();

  /** Spins a little; returns whether to go on waiting. */
  boolean left() {
    Thread.onSpinWait();
    if (System.nanoTime() - begin < nanos) {
      return true;
    }
    nanos = TimeUnit.MILLISECONDS.toNanos(1);
    return false;
  }

  /** Waits until the pass is finished; returns whether it was. */
  static boolean untilFinished(PullTickets tickets) {
    Patience patience = new Patience();
    while (!tickets.finished()) {
      if (!patience.left()) {
        return false;
      }
    }
    return true;
  }
}
