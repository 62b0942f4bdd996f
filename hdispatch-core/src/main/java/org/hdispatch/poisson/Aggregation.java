package org.hdispatch.poisson;

import java.util.Arrays;

/**
 * Puts the nodes of a cell together to aggregates: those in the same 2 x 2 x 2 blocks that are
 * connected inside the block. An aggregate without any link to the outside is a whole cluster: a
 * constant there is no error, so it takes no part in the coarser levels.
 */
final class Aggregation {
  private final int edge; // blocks along the edge of the cell's box
  private int[] parent = {};
  private boolean[] outside = {};

  Aggregation(int edge) {
    this.edge = edge;
  }

  /**
   * Finds the aggregates of a cell and notes them there, with the place of each in the box of half
   * as many blocks.
   */
  void find(GraphCell cell) {
    if (parent.length < cell.nodes) {
      parent = new int[cell.nodes];
      outside = new boolean[cell.nodes];
    }
    for (int node = 0; node < cell.nodes; node++) {
      parent[node] = node;
      outside[node] = false;
    }
    join(cell);
    findLinksOutside(cell);
    number(cell);
  }

  private void join(GraphCell cell) {
    Links links = cell.upper;
    for (int node = 0; node < cell.nodes; node++) {
      int block = block(cell.position[node]);
      for (int n = links.begin(node); n < links.end(node); n++) {
        int other = links.to()[n];
        if (links.mobility()[n] > 0 && block(cell.position[other]) == block) {
          int a = root(node);
          int b = root(other);
          parent[Math.max(a, b)] = Math.min(a, b);
        }
      }
    }
  }

  private void findLinksOutside(GraphCell cell) {
    for (char node : cell.halo.row()) {
      outside[root(node)] = true;
    }
    Links links = cell.upper;
    for (int node = 0; node < cell.nodes; node++) {
      if (cell.ground != null && cell.ground[node] > 0) {
        outside[root(node)] = true;
      }
      for (int n = links.begin(node); n < links.end(node); n++) {
        int other = links.to()[n];
        if (root(other) != root(node)) {
          outside[root(node)] = true;
          outside[root(other)] = true;
        }
      }
    }
  }

  private void number(GraphCell cell) {
    int half = edge / 2;
    long[] order = new long[cell.nodes]; // block, first node
    int count = 0;
    for (int node = 0; node < cell.nodes; node++) {
      if (root(node) == node && outside[node]) {
        order[count++] = (long) block(cell.position[node]) << 32 | node;
      }
    }
    Arrays.sort(order, 0, count);
    char[] places = new char[count];
    char[] numberOfRoot = new char[cell.nodes];
    Arrays.fill(numberOfRoot, GraphCell.NONE);
    for (int n = 0; n < count; n++) {
      places[n] = (char) (order[n] >>> 32);
      numberOfRoot[(int) order[n]] = (char) n;
    }
    assert half * half * half <= Character.MAX_VALUE;
    cell.aggregate = new char[cell.nodes];
    for (int node = 0; node < cell.nodes; node++) {
      cell.aggregate[node] = numberOfRoot[root(node)];
    }
    cell.restricted = new double[count];
    cell.places = places;
  }

  private int root(int node) {
    int at = node;
    while (parent[at] != at) {
      parent[at] = parent[parent[at]];
      at = parent[at];
    }
    return at;
  }

  /** Place of the block of a position: x / 2 + half (y / 2 + half z / 2). */
  private int block(int position) {
    int half = edge / 2;
    int x = position % edge;
    int y = position / edge % edge;
    int z = position / (edge * edge);
    return x / 2 + half * (y / 2 + half * (z / 2));
  }
}
