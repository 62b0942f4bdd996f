package org.hdispatch.app.steady;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hdispatch.porous.flow.Approach;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.flow.StopRule;

/**
 * Records how k comes to its steady value, which is known, and has enough once k is there: when the
 * stop rule has been met, and the last measurements in a row are all close.
 *
 * <p>One measurement would not do: from rest, k rises above its steady value and comes down to it.
 */
final class CourseRecorder implements FlowListener {
  private static final int IN_A_ROW = 4;

  private final Approach approach;
  private final double steady;
  private final double close;
  private final StopRule rule;
  private final List<SteadyCourse.Point> points = new ArrayList<>();
  private double relaxationTime;
  private SteadyCourse.Point stop; // null: not yet
  private int inARow;

  /**
   * A recorder that has heard nothing yet.
   *
   * @param approach the way that is taken
   * @param steady the steady k, voxel²
   * @param close relative error that is close enough
   * @param tolerance of the stop rule
   */
  CourseRecorder(Approach approach, double steady, double close, double tolerance) {
    this.approach = approach;
    this.steady = steady;
    this.close = close;
    rule = new StopRule(tolerance);
  }

  @Override
  public void started(Start start) {
    relaxationTime = start.relaxationTime();
  }

  @Override
  public void progressed(Progress now) {
    SteadyCourse.Point point =
        new SteadyCourse.Point(
            now.step(),
            now.secondsStepping() + now.secondsPressure(),
            now.secondsPressure(),
            now.permeability(),
            now.errorEstimate());
    points.add(point);
    boolean met = rule.isMet(now.errorEstimate(), now.corrections());
    if (met && stop == null) {
      stop = point;
    }
    inARow = Math.abs(now.permeability() / steady - 1) <= close ? inARow + 1 : 0;
  }

  @Override
  public boolean enough() {
    return stop != null && inARow >= IN_A_ROW;
  }

  /** What was recorded. */
  SteadyCourse course() {
    return new SteadyCourse(approach, relaxationTime, steady, points, Optional.ofNullable(stop));
  }
}
