package org.hdispatch.dispatch;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Tells a lost wake-up from a late one, by patience: jcstress itself would wait without end for a
 * thread that hangs while it sizes up a test.
 */
final class Awakening {
  private static final long PATIENCE = TimeUnit.SECONDS.toNanos(10);

  private volatile boolean awake;

  /** Drops a permit left from an earlier wake-up: it would make up for a lost one. */
  static void dropPermit() {
    LockSupport.unpark(Thread.currentThread());
    LockSupport.park();
  }

  /** Says that the thread which waited is awake. */
  void awake() {
    awake = true;
  }

  /**
   * Waits until the other thread is awake. One that sleeps on is woken behind the back of the
   * signals.
   *
   * @return whether that was needed
   */
  boolean lost(Signals signals, int sleeper) {
    long begin = System.nanoTime();
    while (System.nanoTime() - begin < PATIENCE) {
      if (awake) {
        return false;
      }
      Thread.onSpinWait();
    }
    while (!awake) {
      LockSupport.unpark(signals.thread(sleeper));
      Thread.yield();
    }
    return true;
  }
}
