package org.hdispatch.poisson;

/**
 * Links between the nodes of a cell, row by row and three by three: those of node m stand in the
 * triples start[m] to start[m + 1] - 1. A triple that is not full has links of mobility 0 to m.
 * (Three is what a node of the finest level has at most on either side; loops over the six need no
 * inner loop then.)
 *
 * @param start first triple of each node, and the number of all; length nodes + 1
 * @param to the node at the other end; length 3 x triples
 * @param mobility of each link; length 3 x triples
 */
record Links(int[] start, char[] to, double[] mobility) {
  /** Place of the first link of a node; those of mobility 0 fill triples up. */
  int begin(int node) {
    return 3 * start[node];
  }

  /** Place behind the last link of a node. */
  int end(int node) {
    return 3 * start[node + 1];
  }

  long bytes() {
    return 4L * start.length + 2L * to.length + 8L * mobility.length;
  }
}
