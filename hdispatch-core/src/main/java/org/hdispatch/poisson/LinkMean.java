package org.hdispatch.poisson;

/** Mobility of the link between two active nodes, one spacing apart. */
@FunctionalInterface
public interface LinkMean {
  /** Harmonic mean, 2 K L / (K + L): each node fills its half of the way, in series. */
  LinkMean HARMONIC = (one, other) -> 2 * one * (other / (one + other));

  /**
   * Mobility of a link; symmetric in its arguments, not negative, 0 for no link.
   *
   * @param one mobility of one node, positive
   * @param other mobility of the other node, positive
   */
  double of(double one, double other);
}
