package org.hdispatch.dispatch;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntFunction;

/**
 * The threads, and how they wait for each other: wakes the workers when a pass opens and the caller
 * when it is done; spins, then parks.
 *
 * <p>Parking is Dekker's pattern: whoever goes to sleep raises its flag and then looks once more;
 * whoever has news writes it and then looks at the flag. Both sides use volatile accesses or a full
 * fence in between, so at least one of them sees the other, and no wake-up is lost.
 */
final class Signals {
  private static final VarHandle WORD = MethodHandles.arrayElementVarHandle(long[].class);
  private static final VarHandle THREAD = MethodHandles.arrayElementVarHandle(Thread[].class);
  private static final int STRIDE = 16; // 128 bytes between hot words
  private static final int EPOCH = STRIDE;
  private static final int FIRST_PARKED = 2 * STRIDE;

  private final long spins;
  private final Thread[] threads; // by worker; 0 is the caller of the loop that runs now, if any
  private final long[] words;

  Signals(int workers, WaitPolicy policy) {
    spins = policy.spins();
    threads = new Thread[workers];
    words = new long[FIRST_PARKED + (workers + 1) * STRIDE];
  }

  /** Says which thread a worker is, or that it is none at present. */
  void register(int worker, Thread thread) {
    THREAD.setVolatile(threads, worker, thread);
  }

  /** The thread of a worker. */
  Thread thread(int worker) {
    return (Thread) THREAD.getVolatile(threads, worker);
  }

  /** Starts a daemon thread for every worker but worker 0. */
  void start(Runnable[] workers, IntFunction<String> name) {
    for (int worker = 1; worker < threads.length; worker++) {
      Thread thread = new Thread(null, workers[worker], name.apply(worker));
      thread.setDaemon(true);
      register(worker, thread);
    }
    for (int worker = 1; worker < threads.length; worker++) {
      threads[worker].start();
    }
  }

  /** Whether this thread is a worker now. */
  boolean isWorker(Thread thread) {
    for (int worker = 0; worker < threads.length; worker++) {
      if (thread(worker) == thread) {
        return true;
      }
    }
    return false;
  }

  /** Waits until all threads that were started have ended. */
  void join() {
    boolean interrupted = false;
    for (int worker = 1; worker < threads.length; worker++) {
      while (threads[worker].isAlive()) {
        try {
          threads[worker].join();
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Announces a pass (or the end) to the workers. One full fence orders all that the caller has
   * written before it, whichever word it is, with all flags that it reads after it.
   */
  void announce(long epoch) {
    WORD.setRelease(words, EPOCH, epoch);
    VarHandle.fullFence();
    for (int worker = 1; worker < threads.length; worker++) {
      wake(worker);
    }
  }

  /** Waits, as a worker, until another epoch than the given one is announced, and returns it. */
  long awaitOther(long epoch, int worker) {
    for (long spin = 0; spin < spins; spin++) {
      long announced = (long) WORD.getAcquire(words, EPOCH);
      if (announced != epoch) {
        return announced;
      }
      Thread.onSpinWait();
    }
    while (true) {
      WORD.setVolatile(words, parked(worker), 1L);
      long announced = (long) WORD.getVolatile(words, EPOCH);
      if (announced != epoch) {
        WORD.setVolatile(words, parked(worker), 0L);
        return announced;
      }
      LockSupport.park(this);
      Thread.interrupted(); // nobody's business; cleared, for an interrupted thread cannot park
    }
  }

  /** Waits, as the caller, until the pass is done. May return early: ask again. */
  void awaitFinished(PullTickets tickets) {
    for (long spin = 0; spin < spins; spin++) {
      if (tickets.finished() || Thread.currentThread().isInterrupted()) {
        return;
      }
      Thread.onSpinWait();
    }
    WORD.setVolatile(words, parked(0), 1L);
    if (!tickets.finished()) {
      LockSupport.park(this);
    }
    WORD.setVolatile(words, parked(0), 0L);
  }

  /** Tells the caller that the pass is done. */
  void finished() {
    wake(0);
  }

  private void wake(int worker) {
    if ((long) WORD.getVolatile(words, parked(worker)) != 0) {
      WORD.setVolatile(words, parked(worker), 0L);
      LockSupport.unpark(thread(worker)); // read after the flag: never that of an earlier run
    }
  }

  private static int parked(int worker) {
    return FIRST_PARKED + worker * STRIDE;
  }
}
