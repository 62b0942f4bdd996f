package org.hdispatch.poisson;

/** A cell of nodes at one level: their links, and the vectors of the iteration there. */
final class GraphCell {
  /** In place of an aggregate: the node has none, its cluster is done with at this level. */
  static final char NONE = Character.MAX_VALUE;

  final long key;
  final int nodes;

  /** Place of each node in the box of the cell, edge blocks to a side: x + edge (y + edge z). */
  final char[] position;

  // Set by the linker.
  Links lower; // to nodes of this cell that come before
  Links upper; // to those that come after
  HaloLinks halo; // to nodes of other cells
  double[] inverseDiagonal; // 0 where a node has no link at all
  double[] ground; // mobility of the links to fixed sides, null if there is none in the cell

  // Fine level only.
  double[] source; // right-hand side
  double[] fixedSource; // what the fixed sides add to it, null as ground
  char[] cluster; // of each node, among those of this cell
  int[] clusters; // number of each of them among all
  boolean[] clusterFixed; // whether a fixed side is in reach within the cell
  double[] clusterSums; // over this cell

  // To and from the next coarser level, if there is one.
  char[] aggregate; // of each node, within the cell
  char[] places; // of the aggregates in the box of half as many blocks, until that level is made
  double[] restricted; // residual of each aggregate
  GraphCell parent;
  int parentOffset; // of this cell's aggregates among the nodes of the parent
  GraphCell[] children; // cells of the next finer level, in the order of their offsets

  // Vectors of the iteration.
  final double[] solution;
  final double[] residual;
  final double[] smoothed; // after the forward sweep
  final double[] preconditioned; // after the backward sweep
  final double[][] direction; // previous, current
  final double[] product; // A direction

  /** Sums of the last pass over the nodes of this cell; see the kernels. */
  final double[] sums = new double[4];

  GraphCell(long key, char[] position) {
    this.key = key;
    this.position = position;
    nodes = position.length;
    solution = new double[nodes];
    residual = new double[nodes];
    smoothed = new double[nodes];
    preconditioned = new double[nodes];
    direction = new double[2][nodes];
    product = new double[nodes];
  }

  /** Bytes of all arrays. */
  long bytes() {
    long bytes = 2L * nodes + 56L * nodes + lower.bytes() + upper.bytes() + halo.bytes();
    bytes += 8L * nodes;
    bytes += ground == null ? 0 : 8L * nodes;
    bytes += fixedSource == null ? 0 : 8L * nodes;
    bytes += source == null ? 0 : 10L * nodes + 13L * clusters.length;
    bytes += aggregate == null ? 0 : 2L * nodes + 8L * restricted.length;
    return bytes;
  }
}
