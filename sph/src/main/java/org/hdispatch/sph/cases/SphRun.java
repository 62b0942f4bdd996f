package org.hdispatch.sph.cases;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphTimes;

/**
 * How long particles are stepped to be measured: first a warm-up, in which the loops are compiled
 * and cells grow to what they will need.
 *
 * <p>Neighbours are searched for in some steps and not in others, so that only the mean over many
 * steps is a speed.
 *
 * @param warmUpSteps steps before the first that is measured
 * @param steps steps that are measured
 */
public record SphRun(long warmUpSteps, long steps) {
  /** Most steps of a kind. */
  public static final long MOST = 100_000_000;

  private static final long LEAST_WARM_UP = 20;
  private static final long MOST_WARM_UP = 4000;
  private static final long WARM_UP_UPDATES = 1_500_000; // of particles
  private static final long NEWS_UPDATES = 1_000_000; // between two pieces of news

  /** Hears how a run goes on. Called on the caller's thread, not while steps are measured. */
  public interface Listener {
    /** Hears nothing. */
    Listener NONE = new Listener() {};

    /** Stepping begins. */
    default void started() {}

    /** Warm-up is over: what is counted "per step" is counted from here. */
    default void warmedUp() {}

    /**
     * Some steps have been done.
     *
     * @param step how many, warm-up included
     * @param lastStep how many it will be
     */
    default void progressed(long step, long lastStep) {}

    /** Measuring is over. */
    default void measured() {}
  }

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if there is no step to measure, or no warm-up
   */
  public SphRun {
    if (steps < 1 || steps > MOST) {
      throw new IllegalArgumentException("steps must number 1 to " + MOST + ": steps=" + steps);
    }
    if (warmUpSteps < 1 || warmUpSteps > MOST) {
      throw new IllegalArgumentException(
          "warm-up steps must number 1 to " + MOST + ": steps=" + warmUpSteps);
    }
  }

  /** Steps after which the loops are compiled: at least 20, more for few particles. */
  public static long warmUpFor(int particles) {
    return Math.min(MOST_WARM_UP, Math.max(LEAST_WARM_UP, WARM_UP_UPDATES / particles));
  }

  /**
   * Steps a scheme from where it is, and measures.
   *
   * @throws org.hdispatch.dispatch.KernelException if the flow blows up
   * @throws java.util.concurrent.CancellationException if the caller was interrupted
   */
  public SphFigures measure(Dispatcher dispatcher, SphScheme scheme, Listener listener) {
    TimeLoop loop = dispatcher.loop(scheme);
    int particles = scheme.particles();
    listener.started();
    long done = loop.tick().step();
    stepTo(loop, done + warmUpSteps, particles, listener);
    loop.resetStats();
    SphTimes before = scheme.times();
    long rebuilds = scheme.rebuilds();
    listener.warmedUp();
    stepTo(loop, done + warmUpSteps + steps, particles, listener);
    listener.measured();
    int threads = dispatcher.workers();
    SphTimes after = scheme.times();
    return new SphFigures(
        particles,
        scheme.fluidParticles(),
        scheme.cells().size(),
        threads,
        warmUpSteps,
        loop.stats(),
        new SphTimes(
            (after.search() - before.search()) / threads,
            (after.density() - before.density()) / threads,
            (after.force() - before.force()) / threads),
        scheme.rebuilds() - rebuilds,
        scheme.neighboursMean(),
        scheme.bytes());
  }

  /** Steps in parts, so that there is news of them between. */
  private void stepTo(TimeLoop loop, long last, int particles, Listener listener) {
    long part = Math.max(1, NEWS_UPDATES / particles);
    while (loop.tick().step() < last) {
      loop.run(Math.min(part, last - loop.tick().step()));
      listener.progressed(loop.tick().step(), warmUpSteps + steps);
    }
  }
}
