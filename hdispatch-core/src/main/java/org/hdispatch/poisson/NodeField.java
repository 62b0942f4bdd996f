package org.hdispatch.poisson;

/** A value at every active node. Several workers may ask at the same time. */
@FunctionalInterface
public interface NodeField {
  /** Value at the active node (x, y, z). */
  double at(int x, int y, int z);
}
