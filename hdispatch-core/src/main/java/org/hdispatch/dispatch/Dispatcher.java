package org.hdispatch.dispatch;

import java.util.Objects;
import java.util.concurrent.CancellationException;

/**
 * Owns the enduring threads that pull cells, one of them the caller's own.
 *
 * <p><b>Assumptions and guarantees</b>
 *
 * <ol>
 *   <li>A dispatcher with n workers starts n - 1 daemon threads; the thread that calls {@link
 *       TimeLoop#run} works as worker 0 (test: {@code
 *       DispatcherTest.startsDaemonThreadsAndWorksOnTheCallersToo}).
 *   <li>One loop runs at a time. Several loops may take turns, from any thread (tests: {@code
 *       DispatcherTest.refusesALoopInsideAKernel}, {@code
 *       DispatcherTest.loopsTakeTurnsFromAnyThread}).
 *   <li>Two dispatchers share nothing (test: {@code DispatcherTest.twoDispatchersRunSideBySide}).
 *   <li>After warm-up a step allocates nothing on any of the threads (tests: {@code
 *       DispatcherTest.allocatesNothingAfterWarmUp}, {@code
 *       MovingFrontTest.allocatesNothingOnceGrown}, {@code EventsTest.costNoByteWhenNotRecorded}).
 *   <li>When a kernel throws, the cells not yet claimed are taken back, the pass ends, {@code run}
 *       throws a {@link KernelException}, and the dispatcher stays usable (tests: {@code
 *       DispatcherTest.reportsPassCellStepAndWorkerOfAFailureAndStaysUsable}, {@code
 *       DispatcherRandomStepsTest.everyCellExactlyOnce}).
 *   <li>{@link TimeLoop#cancel}, and an interruption of the caller, end a run in the same way,
 *       after the cells in work (tests: {@code
 *       DispatcherTest.cancelFromAnotherThreadEndsTheStepEarly}, {@code
 *       DispatcherTest.interruptionEndsTheStepEarlyAndStaysSet}, {@code
 *       DispatcherRandomStepsTest.outsideCancelsLeaveEveryCellOnceOrNotAtAll}).
 *   <li>{@link #close} ends the run in progress, if any, after the cells in work, and returns when
 *       that run has and all threads are gone (test: {@code
 *       DispatcherTest.closeEndsARunOnAnotherThreadAndJoinsEveryThread}).
 * </ol>
 */
public final class Dispatcher implements AutoCloseable {
  private final Crew crew;
  private final Handout handout;

  private Dispatcher(Builder builder) {
    int count = builder.workers;
    WaitPolicy policy = builder.waitPolicy == null ? WaitPolicy.fitting(count) : builder.waitPolicy;
    handout = builder.handout;
    crew = new Crew(count, policy, builder::threadName);
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
    return crew.size();
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
    return new TimeLoop(crew, handout, scheme, lifetime);
  }

  /**
   * Ends the run in progress, if any, after the cells in work, waits until it has returned, and
   * joins the threads. Called from within a run (a kernel, a stop condition) it does not wait.
   */
  @Override
  public void close() {
    crew.close();
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
