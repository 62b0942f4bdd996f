package org.hdispatch.dispatch;

import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntFunction;

/**
 * The passes of the enduring threads: how one is opened, worked off, and ended early.
 *
 * <p>Whatever ends a pass early (failure, cancel, interruption, close) does the same: it takes back
 * the tasks that nobody has claimed and counts them as done; those in work finish, and the pass
 * ends as ever. Whoever asks raises a flag and then reads which pass is open, or its tickets; the
 * caller opens the pass and then reads the flags (Dekker: one of the two sees the other).
 */
final class Crew {
  private final PullTickets tickets;
  private final Signals signals;
  private final Worker[] workers;
  private final AtomicBoolean running = new AtomicBoolean();
  private final AtomicReference<Throwable> failure = new AtomicReference<>();
  private volatile boolean closed;
  private volatile Run active = new Run();

  // Written by the caller before it opens a pass, read by workers under a claim.
  private Task task;
  private long epoch;

  // Written by the worker whose failure came first, under its claim; read by the caller afterwards.
  private int failedIndex;
  private int failedWorker;

  /** A run in progress, as the threads that may end it early see it. */
  static final class Run {
    private volatile boolean cancelled;
    private final AtomicLong openPass = new AtomicLong();
  }

  /** Starts a thread for every worker but the first, who is the caller. */
  Crew(int count, WaitPolicy policy, IntFunction<String> threadName) {
    tickets = new PullTickets(count);
    signals = new Signals(count, policy);
    workers = new Worker[count];
    for (int id = 0; id < count; id++) {
      workers[id] = new Worker(id, count, this, tickets, signals);
    }
    try {
      signals.start(workers, threadName);
    } catch (Throwable noMoreThreads) { // leave none behind that nobody can close
      closed = true;
      signals.announce(-1);
      throw noMoreThreads;
    }
  }

  int size() {
    return workers.length;
  }

  Worker worker(int id) {
    return workers[id];
  }

  /** Thread of a worker; that of worker 0 is the caller's, null between runs. */
  Thread thread(int id) {
    return signals.thread(id);
  }

  boolean closed() {
    return closed;
  }

  /** Makes the current thread worker 0 until {@link #leave}. */
  void enter(Run run) {
    if (closed) {
      throw Refusal.closed();
    }
    if (!running.compareAndSet(false, true)) {
      throw Refusal.busy();
    }
    signals.register(0, Thread.currentThread());
    active = run;
  }

  void leave(Run run) {
    run.cancelled = false; // whoever asked during this run has been heard
    signals.register(0, null);
    running.set(false);
  }

  /** Throws CancellationException if the run was cancelled, the caller interrupted, this closed. */
  void check(Run run) {
    if (closed) {
      throw Refusal.closedMeanwhile();
    }
    if (run.cancelled) {
      run.cancelled = false;
      throw Refusal.cancelled();
    }
    if (Thread.currentThread().isInterrupted()) {
      throw Refusal.interrupted();
    }
  }

  /**
   * Runs the tasks of one pass and returns when all are done.
   *
   * @param ends segments, see {@link PullTickets#open}
   * @throws CancellationException see {@link #check}
   */
  void dispatch(Task newTask, int[] ends, Handout how, Run run) {
    if (ends[ends.length - 1] == 0) {
      return;
    }
    task = newTask;
    long pass = ++epoch;
    tickets.open(pass, ends, how);
    run.openPass.setRelease(pass);
    signals.announce(pass); // a full fence lies between what is written above and the flags
    if (closed || run.cancelled || failure.get() != null) {
      takeBack(pass);
    }
    workers[0].pull();
    boolean interrupted = false;
    while (!tickets.finished()) {
      signals.awaitFinished(tickets);
      if (Thread.interrupted()) { // cleared, for an interrupted thread cannot park
        interrupted = true;
        takeBack(pass);
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    Throwable cause = failure.get();
    if (cause != null) {
      failure.set(null);
      throw newTask.failure(failedIndex, failedWorker, cause);
    }
    check(run);
  }

  /**
   * Runs a claimed task and all that the worker can claim after it. If one fails, the rest of the
   * pass is taken back.
   *
   * @return number of tasks taken back, which the worker has to count as done
   */
  int runFrom(int first, Worker worker) {
    try {
      task.runFrom(first, worker);
      return 0;
    } catch (Throwable cause) { // kept as it is; the caller reports it when the pass has ended
      if (failure.compareAndSet(null, cause)) {
        failedIndex = worker.inWork();
        failedWorker = worker.id();
      }
      return takeRest();
    }
  }

  /** Takes back the rest of the pass in work; for a worker, who has to count it as done. */
  int takeRest() {
    return tickets.drain(epoch);
  }

  /** Asks a run to end; safe from any thread. */
  void cancel(Run run) {
    run.cancelled = true;
    long pass = run.openPass.get();
    if (run.cancelled) { // else it has been heard, and the pass may be of the next run
      takeBack(pass);
    }
  }

  /** Ends the run in progress; waits for it and for the threads, unless called from within. */
  void close() {
    closed = true;
    takeBack(active.openPass.get());
    signals.announce(-1);
    if (signals.isWorker(Thread.currentThread())) {
      return;
    }
    signals.join();
    while (running.get()) {
      LockSupport.parkNanos(10_000); // the caller, on its way out of the run
    }
  }

  private void takeBack(long pass) {
    int drained = tickets.drain(pass);
    if (drained > 0 && tickets.finish(drained)) {
      signals.finished();
    }
  }
}
