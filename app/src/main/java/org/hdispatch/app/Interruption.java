package org.hdispatch.app;

import java.util.function.IntSupplier;

/**
 * Lets Ctrl-C end the computing thread in order: when the JVM is told to stop, the thread is
 * interrupted and has a moment to unwind, so that no file is left half-written.
 *
 * <p>The JVM halts when its shutdown hooks are done, wherever the other threads are; hence the hook
 * waits for the thread to leave its work, but not for long: Ctrl-C must end the program within a
 * second.
 */
final class Interruption {
  private static final long PATIENCE_MILLIS = 500;

  private final Object unwound = new Object();
  private final Thread computing;
  private final Thread hook;
  private boolean done; // guarded by unwound

  private Interruption(Thread computing) {
    this.computing = computing;
    hook = new Thread(this::interruptAndWait, "hdispatch-interruption");
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Does work on this thread that Ctrl-C ends in order. */
  static int during(IntSupplier work) {
    Interruption interruption = new Interruption(Thread.currentThread());
    try {
      return work.getAsInt();
    } finally {
      interruption.end();
    }
  }

  private void interruptAndWait() {
    computing.interrupt();
    long deadline = System.nanoTime() + PATIENCE_MILLIS * 1_000_000;
    synchronized (unwound) {
      long left = PATIENCE_MILLIS;
      while (!done && left > 0) {
        try {
          unwound.wait(left);
        } catch (InterruptedException e) {
          return; // nobody interrupts a hook; if somebody does, there is nothing to wait for
        }
        left = (deadline - System.nanoTime()) / 1_000_000;
      }
    }
  }

  /** The work is over: tells the hook, or takes it away. */
  private void end() {
    synchronized (unwound) {
      done = true;
      unwound.notifyAll();
    }
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The JVM is stopping already, and the hook has just been told.
    }
  }
}
