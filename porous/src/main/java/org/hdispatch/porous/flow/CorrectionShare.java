package org.hdispatch.porous.flow;

/**
 * How much of a correction of the pressure is added: less when more gathers than before, and
 * nothing any more where that does not help.
 */
final class CorrectionShare {
  /** More than all of it overshoots. */
  private static final double MOST = 0.9;

  private double share = MOST;
  private double leastGathered = Double.POSITIVE_INFINITY;

  /** Half as much from now on, if clearly more mass gathers than has before. */
  void judge(double gathered) {
    if (gathered > 1.5 * leastGathered) {
      share /= 2;
    }
    leastGathered = Math.min(leastGathered, gathered);
  }

  double share() {
    return share;
  }

  /** Whether corrections are still made: not once their share had to be halved twice. */
  boolean helpful() {
    return share > 0.25;
  }
}
