package org.hdispatch.porous.flow;

import org.hdispatch.dispatch.TimeLoop;

/** Steps a flow until it is steady, and keeps what that took. */
final class Stepping {
  /** A flow as it is stepped. */
  interface Flow {
    /** Steps on, measures, and corrects the pressure where that helps. */
    void advance(long steps);

    /** Estimated relative error of k. */
    double errorEstimate();

    /** Corrections of the pressure so far. */
    int corrections();
  }

  private final TimeLoop loop;
  private final FlowOptions options;
  private final FlowListener listener;
  private final int leastWarmUp;
  private long warmUpSteps;
  private double warmUpSeconds;

  /**
   * For one run.
   *
   * @param leastWarmUp steps before what is counted "per step" is counted
   */
  Stepping(TimeLoop loop, FlowOptions options, FlowListener listener, int leastWarmUp) {
    this.loop = loop;
    this.options = options;
    this.listener = listener;
    this.leastWarmUp = leastWarmUp;
  }

  /**
   * Steps until the flow is steady, the listener has enough or no steps are left.
   *
   * @param interval steps between measurements
   * @return whether it is steady
   */
  boolean toSteadyState(Flow flow, int interval) {
    StopRule steady = new StopRule(options.tolerance());
    boolean converged = false;
    boolean ended = false;
    while (!ended && steps() < options.maxSteps()) {
      flow.advance(Math.min(interval, options.maxSteps() - steps()));
      converged = steady.isMet(flow.errorEstimate(), flow.corrections());
      ended = converged || listener.enough();
      if (warmUpSteps == 0 && steps() >= leastWarmUp && !ended) {
        warmUpSteps = steps();
        warmUpSeconds = loop.stats().nanos() * 1e-9;
        loop.resetStats();
        listener.warmedUp();
      }
    }
    listener.stepped();
    return converged;
  }

  /** Tells the listener how far it is. */
  void tell(Flow flow, double permeability, double secondsPressure, long fluid) {
    listener.progressed(
        new FlowListener.Progress(
            steps(),
            options.maxSteps(),
            permeability,
            flow.errorEstimate(),
            options.tolerance(),
            flow.corrections(),
            seconds(),
            secondsPressure,
            fluid * (double) steps() / seconds() * 1e-6));
  }

  /** Steps done. */
  long steps() {
    return loop.tick().step();
  }

  /** Wall time of all steps, s. */
  private double seconds() {
    return warmUpSeconds + loop.stats().nanos() * 1e-9;
  }

  /** What it took, for so many fluid nodes or particles. */
  SteadyFlow.Work work(long fluid) {
    return new SteadyFlow.Work(fluid, steps(), seconds(), warmUpSteps, loop.stats());
  }
}
