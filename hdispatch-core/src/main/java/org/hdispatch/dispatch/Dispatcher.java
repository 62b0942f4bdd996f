package org.hdispatch.dispatch;

import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;

/**
 * Owns the enduring threads that pull cells, one of them the caller's own.
 *
 * <p><b>Assumptions and guarantees</b>
 *
 * <ol>
 *   <li>A dispatcher with n workers starts n - 1 daemon threads; the thread that calls {@link
 *       TimeLoop#run} works as worker 0.
 *   <li>One loop runs at a time. Several loops may take turns, from any thread.
 *   <li>Two dispatchers share nothing.
 *   <li>After warm-up a step allocates nothing on any of the threads.
 *   <li>When a kernel throws, the cells not yet claimed are taken back, the pass ends, {@code run}
 *       throws a {@link KernelException}, and the dispatcher stays usable.
 *   <li>{@link #close} ends the run in progress, if any, after the cells in work, and returns when
 *       that run has and all threads are gone.
 * </ol>
 */
public final class Dispatcher implements AutoCloseable {
  private final Worker[] workers;
  private final Thread[] threads;
  private final PullTickets tickets;
  private final Signals signals;
  private final Handout handout;
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

  /** A pass as the workers see it: tasks 0 to n - 1. */
  interface Task {
    /** Runs one task. */
    void run(int index, int worker);

    /** The exception that says what failed. */
    RuntimeException failure(int index, int worker, Throwable cause);
  }

  private Dispatcher(Builder builder) {
    int count = builder.workers;
    WaitPolicy policy = builder.waitPolicy == null ? WaitPolicy.fitting(count) : builder.waitPolicy;
    handout = builder.handout;
    tickets = new PullTickets(count);
    signals = new Signals(count, policy);
    workers = new Worker[count];
    threads = new Thread[count];
    for (int id = 0; id < count; id++) {
      workers[id] = new Worker(id, count, this, tickets, signals);
    }
    for (int id = 1; id < count; id++) {
      threads[id] = new Thread(null, workers[id], builder.threadName(id));
      threads[id].setDaemon(true);
      signals.register(id, threads[id]);
    }
    try {
      for (int id = 1; id < count; id++) {
        threads[id].start();
      }
    } catch (Throwable noMoreThreads) { // leave none behind that nobody can close
      closed = true;
      signals.announce(-1);
      throw noMoreThreads;
    }
  }

  /**
   * A dispatcher that pulls.
   *
   * @param workers number of workers, the caller's thread included
   * @throws IllegalArgumentException if {@code workers} is less than 1
   */
  public static Dispatcher withWorkers(int workers) {
    return builder().workers(workers).build();
  }

  /** A builder with one worker per processor, pulling. */
  public static Builder builder() {
    return new Builder();
  }

  /** Number of workers, the caller's thread included. */
  public int workers() {
    return workers.length;
  }

  /** A loop that keeps one scratch per worker as long as the loop lives. */
  public <C, S> TimeLoop loop(Scheme<C, S> scheme) {
    return loop(scheme, ScratchLifetime.ENDURING);
  }

  /**
   * Makes a loop over a scheme; every worker makes its scratch now. The loop's tick starts at step
   * 0, so it takes buffer 0 for the previous one: state that another loop has stepped an odd number
   * of times is not where it looks.
   *
   * @throws IllegalStateException if a loop is running or the dispatcher is closed
   * @throws KernelException if a scratch could not be made
   * @throws CancellationException if the caller was interrupted or the dispatcher closed meanwhile
   */
  public <C, S> TimeLoop loop(Scheme<C, S> scheme, ScratchLifetime lifetime) {
    return TimeLoop.of(this, scheme, lifetime);
  }

  /**
   * Ends the run in progress, if any, after the cells in work, waits until it has returned, and
   * joins the threads. Called from a kernel it does not wait.
   */
  @Override
  public void close() {
    closed = true;
    takeBack(active.openPass);
    signals.announce(-1);
    if (inKernel()) {
      return;
    }
    boolean interrupted = false;
    for (int id = 1; id < threads.length; id++) {
      while (threads[id].isAlive()) {
        try {
          threads[id].join();
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
    }
    while (running.get()) {
      LockSupport.parkNanos(10_000); // the caller, on its way out of the run
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** Whether this is one of the threads that process cells now. */
  private boolean inKernel() {
    Thread current = Thread.currentThread();
    if (running.get() && signals.thread(0) == current) {
      return true;
    }
    for (int id = 1; id < threads.length; id++) {
      if (threads[id] == current) {
        return true;
      }
    }
    return false;
  }

  boolean closed() {
    return closed;
  }

  Handout handout() {
    return handout;
  }

  Worker worker(int id) {
    return workers[id];
  }

  /** Thread of a worker; worker 0 is the current thread. */
  Thread thread(int id) {
    return id == 0 ? Thread.currentThread() : threads[id];
  }

  /** A run in progress, as the threads that may end it early see it. */
  static final class Run {
    private volatile boolean cancelled;
    private volatile long openPass;
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
    running.set(false);
  }

  /**
   * Throws if the run is to end early.
   *
   * @throws CancellationException if it was cancelled, the caller interrupted or this closed
   */
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

  /** Asks a run to end; safe from any thread. */
  void cancel(Run run) {
    run.cancelled = true;
    takeBack(run.openPass);
  }

  /**
   * Runs the tasks of one pass and returns when all are done.
   *
   * @param ends segments, see {@link PullTickets#equalSegments}
   * @throws CancellationException see {@link #check}
   */
  void dispatch(Task newTask, int[] ends, Handout how, Run run) {
    if (ends[ends.length - 1] == 0) {
      return;
    }
    task = newTask;
    long pass = ++epoch;
    tickets.open(pass, ends, how);
    run.openPass = pass;
    // Dekker with cancel() and close(): they raise their flag first and then read openPass.
    if (closed || run.cancelled) {
      takeBack(pass);
    }
    signals.announce(pass);
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
   * Runs a claimed task. If it fails, or worker 0 has been interrupted, the rest of the pass is
   * taken back.
   *
   * @return number of further tasks that the worker has to count as done
   */
  int runTask(int index, int worker) {
    Task current = task;
    try {
      current.run(index, worker);
    } catch (Throwable cause) { // kept as it is; the caller reports it when the pass has ended
      if (failure.compareAndSet(null, cause)) {
        failedIndex = index;
        failedWorker = worker;
      }
      return tickets.drain(epoch);
    }
    if (worker == 0 && Thread.currentThread().isInterrupted()) {
      return tickets.drain(epoch);
    }
    return 0;
  }

  private void takeBack(long pass) {
    int drained = tickets.drain(pass);
    if (drained > 0 && tickets.finish(drained)) {
      signals.finished();
    }
  }

  /** Settings of a dispatcher; each has a default. */
  public static final class Builder {
    private int workers = Runtime.getRuntime().availableProcessors();
    private Handout handout = Handout.PULL;
    private WaitPolicy waitPolicy;
    private String name = "hdispatch";

    private Builder() {}

    /**
     * Sets the number of workers, the caller's thread included. Default: one per processor.
     *
     * @throws IllegalArgumentException if it is less than 1
     */
    public Builder workers(int count) {
      if (count < 1) {
        throw new IllegalArgumentException("workers must number at least 1: workers=" + count);
      }
      workers = count;
      return this;
    }

    /** Sets how cells reach the workers. Default: {@link Handout#PULL}. */
    public Builder handout(Handout how) {
      handout = Objects.requireNonNull(how, "handout");
      return this;
    }

    /**
     * Sets what idle threads do. Default: {@link WaitPolicy#SPIN_THEN_PARK}, or {@link
     * WaitPolicy#PARK} with more workers than processors.
     */
    public Builder waitPolicy(WaitPolicy policy) {
      waitPolicy = Objects.requireNonNull(policy, "policy");
      return this;
    }

    /** Sets how the names of the threads begin. Default: {@code hdispatch}. */
    public Builder name(String prefix) {
      name = Objects.requireNonNull(prefix, "prefix");
      return this;
    }

    private String threadName(int worker) {
      return name + "-worker-" + worker;
    }

    /** Starts the threads. */
    public Dispatcher build() {
      return new Dispatcher(this);
    }
  }
}
