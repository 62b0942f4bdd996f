package org.hdispatch.lbm.duct;

import org.hdispatch.dispatch.LoopStats;

/**
 * What was measured on a duct.
 *
 * @param duct the duct
 * @param threads workers
 * @param run how long it ran
 * @param secondsPerStep wall time of a step, s, measured two by two
 * @param gigabytesPerSecond bandwidth beside it, bytes read plus bytes written in place, 10^9 a
 *     second
 * @param bundles number of bundles
 * @param heldBytes bytes held for the nodes
 * @param stats what the workers did in the measured steps
 * @param lastStep steps done in the end
 * @param kOverW2 mean velocity times nu/(g W²) at the last step
 */
public record DuctFigures(
    Duct duct,
    int threads,
    DuctRun run,
    Spread secondsPerStep,
    Spread gigabytesPerSecond,
    int bundles,
    long heldBytes,
    LoopStats stats,
    long lastStep,
    double kOverW2) {

  /** Million node updates a second, by the median of the steps. */
  public double mlupsMedian() {
    return duct.nodes() / secondsPerStep.median() * 1e-6;
  }

  /** Million node updates a second, by the two fastest steps in a row. */
  public double mlupsBest() {
    return duct.nodes() / secondsPerStep.least() * 1e-6;
  }

  /** Bytes held for a node. */
  public double bytesHeldPerNode() {
    return (double) heldBytes / duct.nodes();
  }

  /**
   * Million node updates a second that the bandwidth beside the run lets through; by its median.
   */
  public double bandwidthMlups() {
    return gigabytesPerSecond.median() * 1e3 / duct.bytesMovedPerNode();
  }

  /**
   * Share of the bandwidth that the steps need: the speed over {@link #bandwidthMlups}; medians.
   */
  public double bandwidthFraction() {
    return mlupsMedian() / bandwidthMlups();
  }

  /** Share of the steady flow that is missing at the last step, at most. */
  public double startUpLeft() {
    return duct.startUpLeft(lastStep);
  }

  /** Whether the flow is steady at the last step. */
  public boolean steady() {
    return startUpLeft() <= DuctRun.STEADY;
  }
}
