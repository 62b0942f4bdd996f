package org.hdispatch.lbm.duct;

import java.util.Objects;
import java.util.function.Predicate;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Tick;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.LbmScheme;

/**
 * How long a duct is stepped to be measured: warm-up, then blocks of steps with sweeps of a probe
 * before, between and after them, so that both see the same machine.
 *
 * <p>Steps are timed two by two: in place every second step is local to the nodes and those between
 * are not, so that a single step would be either too fast or too slow.
 *
 * @param warmUpSteps steps before the first that is measured
 * @param steps steps that are measured, even
 * @param ending when to end
 */
public record DuctRun(long warmUpSteps, long steps, Ending ending) {
  /** Share of the steady flow that may be missing where it counts as steady. */
  public static final double STEADY = 1e-4;

  /** Most steps of a kind. */
  public static final long MOST = 10_000_000;

  private static final int PAIR = 2;
  private static final int BLOCKS = 4;
  private static final int SWEEPS = 3; // of the probe, around each block

  /** Kernels of named vector instructions are compiled late: after 12 to 24 steps of 200³ nodes. */
  private static final long LEAST_WARM_UP = 24;

  private static final long MOST_WARM_UP = 10_000;
  private static final long WARM_UP_UPDATES = 100_000_000;

  /** Node updates between two pieces of news of steps that are not measured. */
  private static final long NEWS_UPDATES = 50_000_000;

  /** When a run ends. */
  public enum Ending {
    /** With the last step that is measured. */
    MEASURED,
    /** When the flow is steady ({@link DuctRun#STEADY}); later steps are not measured. */
    STEADY
  }

  /** Hears how a run goes on. Called on the caller's thread, not while steps are measured. */
  public interface Listener {
    /** Hears nothing. */
    Listener NONE = new Listener() {};

    /** The duct is made, stepping begins. */
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
   * @throws IllegalArgumentException if the steps are not even and at least 2, or there is no
   *     warm-up
   */
  public DuctRun {
    if (steps < PAIR || steps > MOST || steps % PAIR != 0) {
      throw new IllegalArgumentException(
          "steps must be an even number from 2 to " + MOST + ": steps=" + steps);
    }
    if (warmUpSteps < 1 || warmUpSteps > MOST) {
      throw new IllegalArgumentException(
          "warm-up steps must number 1 to " + MOST + ": steps=" + warmUpSteps);
    }
    Objects.requireNonNull(ending, "ending");
  }

  /** Steps after which the kernels of a duct are compiled: at least 24, more for small ducts. */
  public static long warmUpFor(Duct duct) {
    return Math.min(MOST_WARM_UP, Math.max(LEAST_WARM_UP, WARM_UP_UPDATES / duct.nodes()));
  }

  /**
   * Makes a duct, steps it from rest, and measures.
   *
   * @throws IllegalStateException if this JVM cannot run the form of the kernel
   * @throws java.util.concurrent.CancellationException if the caller was interrupted
   */
  public DuctFigures measure(
      Dispatcher dispatcher, Duct duct, BandwidthProbe probe, Listener listener) {
    return new Measurement(dispatcher, duct, probe, listener).figures();
  }

  /** One run. */
  private final class Measurement {
    private final Dispatcher dispatcher;
    private final Duct duct;
    private final LbmScheme scheme;
    private final TimeLoop loop;
    private final BandwidthProbe.Sweeps sweeps;
    private final Listener listener;
    private final long lastStep;
    private final PairClock clock = new PairClock();
    private final double[] gigabytesPerSecond = new double[(BLOCKS + 1) * SWEEPS];
    private int swept;

    Measurement(Dispatcher dispatcher, Duct duct, BandwidthProbe probe, Listener listener) {
      this.dispatcher = dispatcher;
      this.duct = duct;
      this.listener = listener;
      sweeps = probe.on(dispatcher);
      scheme = duct.scheme();
      loop = dispatcher.loop(scheme);
      long measured = warmUpSteps + steps;
      lastStep = ending == Ending.STEADY ? Math.max(measured, duct.stepsUntil(STEADY)) : measured;
    }

    DuctFigures figures() {
      listener.started();
      stepTo(warmUpSteps);
      loop.resetStats();
      listener.warmedUp();
      sweep();
      long pairs = steps / PAIR;
      for (int block = 0; block < BLOCKS; block++) {
        clock.begin();
        loop.runUntil(clock, PAIR * (pairs * (block + 1) / BLOCKS - pairs * block / BLOCKS));
        sweep();
        listener.progressed(loop.tick().step(), lastStep);
      }
      listener.measured();
      var stats = loop.stats();
      stepTo(lastStep);
      return new DuctFigures(
          duct,
          dispatcher.workers(),
          DuctRun.this,
          DuctRun.perStep(clock.nanos),
          Spread.of(gigabytesPerSecond),
          scheme.cells().size(),
          scheme.bytes(),
          stats,
          lastStep,
          duct.kOverW2(scheme));
    }

    /** Steps that are not measured, in parts, so that there is news of them. */
    private void stepTo(long last) {
      long part = Math.max(1, NEWS_UPDATES / duct.nodes());
      while (loop.tick().step() < last) {
        loop.run(Math.min(part, last - loop.tick().step()));
        listener.progressed(loop.tick().step(), lastStep);
      }
    }

    private void sweep() {
      for (int n = 0; n < SWEEPS; n++) {
        gigabytesPerSecond[swept++] = sweeps.gigabytesPerSecond();
      }
    }
  }

  private static Spread perStep(long[] nanosOfPairs) {
    double[] seconds = new double[nanosOfPairs.length];
    for (int n = 0; n < seconds.length; n++) {
      seconds[n] = nanosOfPairs[n] * 1e-9 / PAIR;
    }
    return Spread.of(seconds);
  }

  /** Stops nothing, but notes after each second step how long the two have taken. */
  private final class PairClock implements Predicate<Tick> {
    private final long[] nanos = new long[(int) (steps / PAIR)];
    private int stepped;
    private long last;

    void begin() {
      last = System.nanoTime();
    }

    @Override
    public boolean test(Tick after) {
      stepped++;
      if (stepped % PAIR == 0) {
        long now = System.nanoTime();
        nanos[stepped / PAIR - 1] = now - last;
        last = now;
      }
      return false;
    }
  }
}
