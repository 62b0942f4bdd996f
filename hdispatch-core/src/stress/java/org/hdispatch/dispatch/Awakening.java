package org.hdispatch.dispatch;

import java.util.concurrent.locks.LockSupport;

/** Tells whether a wake-up was lost, and keeps the two actors of a test in step. */
final class Awakening {
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
   * Waits until the other thread is awake; one that sleeps on is woken behind the back of the
   * signals.
   *
   * @return whether that was needed
   */
  boolean lost(Signals signals, int sleeper) {
    Patience patience = new Patience();
    while (!awake) {
      if (!patience.left()) {
        while (!awake) {
          LockSupport.unpark(signals.thread(sleeper));
          Thread.yield();
        }
        return true;
      }
    }
    return false;
  }
}
