package org.hdispatch.poisson;

/**
 * Links of the nodes of a cell, row by row: those of node m stand at start[m] to start[m + 1] - 1.
 *
 * @param start first link of each node, and the number of all; length nodes + 1
 * @param to the node at the other end: below the number of nodes one of the cell's own, from there
 *     on one of its halo
 * @param mobility of each link, positive
 */
record Links(int[] start, char[] to, double[] mobility) {
  long bytes() {
    return 4L * start.length + 2L * to.length + 8L * mobility.length;
  }
}
