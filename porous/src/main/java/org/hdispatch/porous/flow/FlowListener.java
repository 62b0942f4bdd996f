package org.hdispatch.porous.flow;

/** Hears how a flow computation goes on. Called on the caller's thread, between steps. */
public interface FlowListener {
  /** Hears nothing. */
  FlowListener NONE = new FlowListener() {};

  /** The set-up is done, stepping begins. */
  default void started(Start start) {}

  /** Warm-up is over: what is counted "per step" is counted from here. */
  default void warmedUp() {}

  /** Another measurement. */
  default void progressed(Progress progress) {}

  /** Whether enough has been heard: it ends there. Asked after each measurement. */
  default boolean enough() {
    return false;
  }

  /** Stepping is over; the field is read next. */
  default void stepped() {}

  /**
   * What was chosen.
   *
   * @param fluidNodes fluid nodes, slabs included
   * @param relaxationTime tau
   */
  record Start(long fluidNodes, double relaxationTime) {}

  /**
   * Where a computation stands.
   *
   * @param step steps done
   * @param maxSteps steps after which it gives up
   * @param permeability k so far, voxel²
   * @param errorEstimate estimated relative error of k; infinite in the beginning
   * @param tolerance estimate at which it stops
   * @param corrections of the pressure so far
   * @param secondsStepping wall time spent stepping, s
   * @param secondsPressure wall time of all that has to do with pressure: setting up, start,
   *     corrections, s
   * @param mflups million fluid-node updates per second
   */
  record Progress(
      long step,
      long maxSteps,
      double permeability,
      double errorEstimate,
      double tolerance,
      int corrections,
      double secondsStepping,
      double secondsPressure,
      double mflups) {}
}
