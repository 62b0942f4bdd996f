package org.hdispatch.dispatch;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import org.hdispatch.cell.CellMap;

/**
 * Steps one scheme on one dispatcher.
 *
 * <p>A step that fails or is cancelled does not count: the tick stays, and a scheme whose passes
 * read only previous and write only current values can repeat it.
 */
public final class TimeLoop {
  private final Dispatcher dispatcher;
  private final Scheme<?, ?> scheme;
  private final Tick tick = new Tick();
  private final Dispatcher.Run run = new Dispatcher.Run();
  private final int[] segmentEnds;
  private final List<PassTask<?, ?>> passes = new ArrayList<>();
  private final LoopMeter meter;

  private <C, S> TimeLoop(Dispatcher dispatcher, Scheme<C, S> scheme, ScratchLifetime lifetime) {
    this.dispatcher = dispatcher;
    this.scheme = scheme;
    int workers = dispatcher.workers();
    CellMap<C> cells = scheme.cells();
    segmentEnds = PullTickets.equalSegments(cells.size(), workers);
    ScratchShelf<S> shelf = new ScratchShelf<>(scheme::newScratch, workers, lifetime);
    for (Pass<C, S> pass : scheme.passes()) {
      passes.add(new PassTask<>(pass, cells, shelf, tick));
    }
    meter = new LoopMeter(dispatcher);
    dispatcher.enter(run);
    try {
      dispatcher.dispatch(shelf, PullTickets.equalSegments(workers, workers), Handout.STATIC, run);
    } finally {
      dispatcher.leave(run);
    }
  }

  static <C, S> TimeLoop of(Dispatcher dispatcher, Scheme<C, S> scheme, ScratchLifetime lifetime) {
    return new TimeLoop(dispatcher, scheme, lifetime);
  }

  /**
   * Runs this many steps.
   *
   * @throws IllegalArgumentException if {@code steps} is negative
   * @throws KernelException if a kernel threw
   * @throws CancellationException if {@link #cancel} was called, the caller was interrupted (its
   *     interrupt status stays set) or the dispatcher closed
   * @throws IllegalStateException if the dispatcher is running a loop already or is closed
   */
  public void run(long steps) {
    runUntil(after -> false, steps);
  }

  /**
   * Runs until a condition holds, at most this many steps.
   *
   * @param stop asked by the caller's thread after each step
   * @return whether the condition came to hold
   * @throws IllegalArgumentException if {@code maxSteps} is negative
   * @throws KernelException as {@link #run}
   * @throws CancellationException as {@link #run}
   * @throws IllegalStateException as {@link #run}
   */
  public boolean runUntil(Predicate<Tick> stop, long maxSteps) {
    if (maxSteps < 0) {
      throw Refusal.negativeSteps(maxSteps);
    }
    Objects.requireNonNull(stop);
    dispatcher.enter(run);
    try {
      return meteredRun(stop, maxSteps);
    } finally {
      dispatcher.leave(run);
    }
  }

  private boolean meteredRun(Predicate<Tick> stop, long maxSteps) {
    long first = tick.step();
    meter.begin();
    try {
      for (long step = 0; step < maxSteps; step++) {
        step();
        if (stop.test(tick)) {
          return true;
        }
      }
      return false;
    } finally {
      meter.end(tick.step() - first);
    }
  }

  private void step() {
    dispatcher.check(run);
    scheme.beforeStep(tick);
    for (int pass = 0; pass < passes.size(); pass++) {
      dispatcher.dispatch(passes.get(pass), segmentEnds, dispatcher.handout(), run);
    }
    scheme.afterStep(tick);
    tick.advance();
  }

  /**
   * Ends the run in progress after the cells in work, or else the next run before its first step.
   * Safe from any thread.
   */
  public void cancel() {
    dispatcher.cancel(run);
  }

  /** The clock. Read it between steps, or in a kernel. */
  public Tick tick() {
    return tick;
  }

  /**
   * What this loop has done since it was made or {@link #resetStats} was called. A run in progress
   * does not count before it ends; ask on the thread that runs the loop.
   */
  public LoopStats stats() {
    return meter.stats();
  }

  /** Starts the statistics anew, between two runs: after warm-up, say. */
  public void resetStats() {
    meter.reset();
  }

  /** One pass over all cells. */
  private static final class PassTask<C, S> implements Dispatcher.Task {
    private final String name;
    private final CellKernel<? super C, ? super S> kernel;
    private final CellMap<C> cells;
    private final ScratchShelf<S> shelf;
    private final Tick tick;

    PassTask(Pass<C, S> pass, CellMap<C> cells, ScratchShelf<S> shelf, Tick tick) {
      name = pass.name();
      kernel = pass.kernel();
      this.cells = cells;
      this.shelf = shelf;
      this.tick = tick;
    }

    @Override
    public void run(int index, int worker) {
      kernel.process(cells.cellAt(index), shelf.scratch(worker, tick), tick);
    }

    @Override
    public RuntimeException failure(int index, int worker, Throwable cause) {
      return new KernelException(name, cells.keyAt(index), tick.step(), worker, cause);
    }
  }
}
