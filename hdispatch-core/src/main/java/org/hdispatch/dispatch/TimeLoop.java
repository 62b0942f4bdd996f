package org.hdispatch.dispatch;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import org.hdispatch.cell.CellChanges;
import org.hdispatch.cell.CellMap;

/**
 * Steps one scheme on one dispatcher.
 *
 * <p>A step that fails or is cancelled does not count: the tick stays, the cells stay, and a scheme
 * whose passes read only previous and write only current values can repeat it; what {@link
 * Scheme#beforeStep} and {@link Scheme#afterStep} did is repeated with it.
 *
 * <p>A JDK Flight Recording may enable the events {@code org.hdispatch.Step}, {@code
 * org.hdispatch.Pass}, {@code org.hdispatch.CellsChanged} and {@code org.hdispatch.Growth} (bytes
 * that the workers allocated in a step, where there were any). They are off by default, and cost a
 * look at a flag then.
 */
public final class TimeLoop {
  private final Crew crew;
  private final Scheme<?, ?> scheme;
  private final CellMap<?> cells;
  private final Tick.Clock clock = new Tick.Clock();
  private final Tick[] ticks; // by worker
  private final Crew.Run run = new Crew.Run();
  private final Sweep[] sweeps;
  private final LoopMeter meter;
  private final Events.StepDone stepDone = new Events.StepDone();
  private final Events.CellsChanged cellsChanged = new Events.CellsChanged();
  private final Events.Growth growth = new Events.Growth();
  private long revision;

  <C, S> TimeLoop(Crew crew, Handout handout, Scheme<C, S> scheme, ScratchLifetime lifetime) {
    this.crew = crew;
    this.scheme = scheme;
    int workers = crew.size();
    CellMap<C> map = scheme.cells();
    cells = map;
    ticks = new Tick[workers];
    for (int worker = 0; worker < workers; worker++) {
      ticks[worker] = new Tick(clock);
    }
    ScratchShelf<S> shelf = new ScratchShelf<>(scheme::newScratch, workers, lifetime);
    List<Pass<C, S>> passes = scheme.passes();
    sweeps = new Sweep[passes.size()];
    for (int pass = 0; pass < sweeps.length; pass++) {
      sweeps[pass] = new Sweep(crew, handout, new PassTask<>(passes.get(pass), map, shelf, ticks));
    }
    resetSweeps();
    meter = new LoopMeter(crew);
    int[] oneEach = new int[workers];
    PullTickets.cut(workers, oneEach);
    crew.enter(run);
    try {
      crew.dispatch(shelf, oneEach, Handout.STATIC, run);
    } finally {
      crew.leave(run);
    }
  }

  /**
   * Runs this many steps.
   *
   * @throws IllegalArgumentException if {@code steps} is negative
   * @throws KernelException if a kernel threw
   * @throws CancellationException if {@link #cancel} was called, the caller was interrupted (its
   *     interrupt status stays set) or the dispatcher closed
   * @throws IllegalStateException if the dispatcher is running a loop already or is closed, or if
   *     the set of cells was changed during a step other than through {@link Tick#changes}
   * @throws RuntimeException what the scheme threw before or after a step, or while it made a cell
   */
  public void run(long steps) {
    runUntil(after -> false, steps);
  }

  /**
   * Warms up: runs this many steps again and again, until no worker has allocated a byte in them.
   * One such window tells nothing alone: the JVM itself allocates, once, when it replaces code that
   * it has compiled, at any time. The statistics are those of the last window then, so that {@link
   * LoopStats#bytesPerStep} is 0 if warming up came to an end.
   *
   * @param steps of a window
   * @param windows most windows to run; the first is the last where this JVM does not count bytes
   * @return whether nothing was allocated in the last window
   * @throws IllegalArgumentException if {@code steps} is negative
   * @throws KernelException as {@link #run}
   * @throws CancellationException as {@link #run}
   * @throws IllegalStateException as {@link #run}
   * @throws RuntimeException as {@link #run}
   */
  public boolean warmUp(long steps, int windows) {
    long bytes = 1;
    for (int window = 0; window < windows && bytes > 0; window++) {
      resetStats();
      run(steps);
      bytes = stats().bytesPerStep();
    }
    return bytes == 0;
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
   * @throws RuntimeException as {@link #run}
   */
  public boolean runUntil(Predicate<Tick> stop, long maxSteps) {
    if (maxSteps < 0) {
      throw Refusal.negativeSteps(maxSteps);
    }
    Objects.requireNonNull(stop);
    crew.enter(run);
    try {
      return meteredRun(stop, maxSteps);
    } finally {
      crew.leave(run);
    }
  }

  private boolean meteredRun(Predicate<Tick> stop, long maxSteps) {
    long first = clock.step;
    meter.begin();
    try {
      for (long step = 0; step < maxSteps; step++) {
        step();
        if (stop.test(ticks[0])) {
          return true;
        }
      }
      return false;
    } finally {
      meter.end(clock.step - first);
    }
  }

  private void step() {
    crew.check(run);
    boolean recorded = stepDone.isEnabled();
    if (recorded) {
      stepDone.begin();
    }
    boolean growthRecorded = growth.isEnabled();
    long bytesBefore = growthRecorded ? meter.allocatedBytes() : 0;
    boolean complete = false;
    try {
      scheme.beforeStep(ticks[0]);
      if (cells.revision() != revision) { // someone has changed them since the last pass
        resetSweeps();
      }
      for (Sweep sweep : sweeps) {
        sweep.pass(run, clock.step);
        if (cells.revision() != revision) {
          throw Refusal.cellsChanged();
        }
      }
      scheme.afterStep(ticks[0]);
      stepDone.cells = cells.size();
      changeCells();
      complete = true;
    } finally {
      if (!complete) {
        forgetChanges();
      }
    }
    if (recorded) {
      stepDone.end();
      stepDone.step = clock.step;
      stepDone.commit();
    }
    if (growthRecorded) {
      tellGrowth(meter.allocatedBytes() - bytesBefore);
    }
    clock.step++;
  }

  private void tellGrowth(long bytes) {
    if (bytes > 0) {
      growth.step = clock.step;
      growth.bytes = bytes;
      growth.commit();
    }
  }

  private void resetSweeps() {
    revision = cells.revision();
    for (Sweep sweep : sweeps) {
      sweep.reset(cells.size());
    }
  }

  /** Adds and removes the cells that the workers have asked for in this step. */
  private void changeCells() {
    CellChanges all = ticks[0].changes();
    for (int worker = 1; worker < ticks.length; worker++) {
      all.takeAll(ticks[worker].changes());
    }
    if (all.isEmpty()) {
      return;
    }
    boolean recorded = cellsChanged.isEnabled();
    if (recorded) {
      cellsChanged.begin();
    }
    int before = cells.size();
    if (cells.apply(all) && recorded) {
      cellsChanged.end();
      cellsChanged.step = clock.step;
      cellsChanged.before = before;
      cellsChanged.after = cells.size();
      cellsChanged.commit();
    }
  }

  private void forgetChanges() {
    for (Tick tick : ticks) {
      tick.changes().clear();
    }
  }

  /**
   * Ends the run in progress after the cells in work, or else the next run before its first step.
   * Safe from any thread.
   */
  public void cancel() {
    crew.cancel(run);
  }

  /**
   * The clock, for reading: between steps, or in a kernel of another loop. A kernel asks for
   * changes through the tick that it is given; between runs cells are changed by {@link
   * CellMap#apply}.
   */
  public Tick tick() {
    return ticks[0];
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
}
