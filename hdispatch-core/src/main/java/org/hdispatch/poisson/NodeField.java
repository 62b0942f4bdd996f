package org.hdispatch.poisson;

/** A value at every active node. */
@FunctionalInterface
public interface NodeField {
  /** Value at the active node (x, y, z). */
  double at(int x, int y, int z);
}
