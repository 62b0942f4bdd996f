package org.hdispatch.app.steady;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.app.watch.Listeners;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.flow.Approach;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.LbmFlow;
import org.hdispatch.porous.flow.SteadyFlow;

/**
 * Both ways to the steady state, in one rock after the other: first the steady k itself, to a
 * thousandth of the tolerance, then how k comes to it with corrections of the pressure, then
 * without.
 *
 * <p>The first run and the second do the same steps. The first also makes the JIT compile what all
 * three need, so that the second and the third are compared warm.
 */
final class SteadyStudy {
  private final List<Rock> rocks;
  private final FlowOptions options;
  private final int threads;
  private final Consumer<String> warn;
  private final List<SteadyComparison> done = new ArrayList<>();

  /**
   * A study that has not been run.
   *
   * @param rocks what to run it on
   * @param options axis, tolerance of the stop rule, limit of steps, and whatever else is common
   * @param threads workers
   * @param warn hears of rocks that are left out
   */
  SteadyStudy(List<Rock> rocks, FlowOptions options, int threads, Consumer<String> warn) {
    this.rocks = List.copyOf(rocks);
    this.options = options;
    this.threads = threads;
    this.warn = warn;
  }

  /** Hears how a study goes on. */
  @FunctionalInterface
  interface Listener {
    /** Hears nothing. */
    Listener NONE = (number, rock, run, now) -> {};

    /**
     * Another measurement.
     *
     * @param number of the rock, from 1
     * @param rock the rock
     * @param run which of its runs, in a word
     * @param now where that stands
     */
    void progressed(int number, Rock rock, String run, FlowListener.Progress now);
  }

  /**
   * Runs it; what is done at any time can be had from {@link #result}.
   *
   * @throws UsageException if no rock percolates
   * @throws java.util.concurrent.CancellationException if the caller is interrupted meanwhile
   */
  void run(Listener listener) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(threads)) {
      for (int n = 0; n < rocks.size(); n++) {
        compare(dispatcher, n + 1, listener);
      }
    }
    if (done.isEmpty()) {
      throw new UsageException("a rock must percolate: rocks=" + rocks.size());
    }
  }

  private void compare(Dispatcher dispatcher, int number, Listener listener) {
    Rock rock = rocks.get(number - 1);
    SteadyFlow reference =
        solve(
            dispatcher,
            rock,
            options.withApproach(Approach.CORRECTED).withTolerance(result().referenceTolerance()),
            heardBy(listener, number, rock, "steady"));
    if (!reference.percolation().percolates()) {
      warn.accept(
          "rock must percolate, and is left out: rock="
              + rock.name()
              + ", porosity="
              + rock.space().porosity());
      return;
    }
    double steady = reference.permeability();
    done.add(
        new SteadyComparison(
            rock,
            SteadyComparison.Reference.of(reference),
            course(dispatcher, number, Approach.CORRECTED, steady, listener),
            course(dispatcher, number, Approach.PLAIN, steady, listener)));
  }

  private SteadyCourse course(
      Dispatcher dispatcher, int number, Approach approach, double steady, Listener listener) {
    Rock rock = rocks.get(number - 1);
    CourseRecorder recorder =
        new CourseRecorder(approach, steady, result().close(), options.tolerance());
    solve(
        dispatcher,
        rock,
        options.withApproach(approach).withTolerance(result().referenceTolerance()),
        new Listeners(List.of(recorder, heardBy(listener, number, rock, Choices.word(approach)))));
    return recorder.course();
  }

  private static SteadyFlow solve(
      Dispatcher dispatcher, Rock rock, FlowOptions how, FlowListener listener) {
    return LbmFlow.solve(dispatcher, rock.space(), how, listener);
  }

  private static FlowListener heardBy(Listener listener, int number, Rock rock, String run) {
    return new FlowListener() {
      @Override
      public void progressed(Progress now) {
        listener.progressed(number, rock, run, now);
      }
    };
  }

  /** What is done so far. */
  SteadyResult result() {
    return new SteadyResult(options, threads, done);
  }
}
