package org.hdispatch.poisson;

/** Takes the values at the active nodes, one after the other. */
@FunctionalInterface
public interface NodeVisitor {
  /** Takes the value at the active node (x, y, z). */
  void visit(int x, int y, int z, double value);
}
