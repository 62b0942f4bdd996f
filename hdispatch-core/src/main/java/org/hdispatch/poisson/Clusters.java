package org.hdispatch.poisson;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.hdispatch.cell.CellMap;

/**
 * The clusters of nodes that links connect. One without a fixed side knows its solution up to a
 * constant only, and has one at all only if its sources add up to 0.
 */
final class Clusters {
  private final CellMap<GraphCell> cells;
  private final int count;
  private final long[] nodes;
  private final boolean[] fixed;
  private final double[] sums;
  private final double[] means; // of the sources; 0 where a side is fixed

  Clusters(CellMap<GraphCell> cells) {
    this.cells = cells;
    Map<GraphCell, Integer> offsets = new HashMap<>();
    int all = 0;
    for (int n = 0; n < cells.size(); n++) {
      offsets.put(cells.cellAt(n), all);
      all = Math.addExact(all, cells.cellAt(n).nodes);
    }
    int[] parent = new int[all];
    Arrays.setAll(parent, n -> n);
    for (int n = 0; n < cells.size(); n++) {
      join(cells.cellAt(n), offsets, parent);
    }
    count = number(offsets, parent);
    nodes = new long[count];
    fixed = new boolean[count];
    sums = new double[count];
    means = new double[count];
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      for (int m = 0; m < cell.nodes; m++) {
        nodes[cell.cluster[m]]++;
        fixed[cell.cluster[m]] |= cell.ground != null && cell.ground[m] > 0;
      }
    }
  }

  private static void join(GraphCell cell, Map<GraphCell, Integer> offsets, int[] parent) {
    int offset = offsets.get(cell);
    Links links = cell.upper;
    for (int m = 0; m < cell.nodes; m++) {
      for (int n = links.begin(m); n < links.end(m); n++) {
        join(parent, offset + m, offset + links.to()[n]);
      }
    }
    HaloLinks halo = cell.halo;
    for (int n = 0; n < halo.row().length; n++) {
      join(parent, offset + halo.row()[n], offsets.get(halo.cell(n)) + halo.to()[n]);
    }
  }

  private static void join(int[] parent, int one, int other) {
    int a = root(parent, one);
    int b = root(parent, other);
    parent[Math.max(a, b)] = Math.min(a, b);
  }

  private static int root(int[] parent, int node) {
    int at = node;
    while (parent[at] != at) {
      parent[at] = parent[parent[at]];
      at = parent[at];
    }
    return at;
  }

  /** Numbers the clusters in the order of their first nodes, and tells every node its own. */
  private int number(Map<GraphCell, Integer> offsets, int[] parent) {
    int next = 0;
    int[] numbers = new int[parent.length];
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      int offset = offsets.get(cell);
      cell.cluster = new int[cell.nodes];
      for (int m = 0; m < cell.nodes; m++) {
        int root = root(parent, offset + m);
        if (root == offset + m) {
          numbers[root] = next++;
        }
        cell.cluster[m] = numbers[root];
      }
    }
    return next;
  }

  int count() {
    return count;
  }

  /**
   * Finds the mean source of each cluster without a fixed side.
   *
   * @return the largest |sum of sources| of such a cluster
   */
  double balance() {
    Arrays.fill(sums, 0);
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      for (int m = 0; m < cell.nodes; m++) {
        sums[cell.cluster[m]] += cell.source[m];
      }
    }
    double largest = 0;
    for (int c = 0; c < count; c++) {
      means[c] = fixed[c] ? 0 : sums[c] / nodes[c];
      largest = fixed[c] ? largest : Math.max(largest, Math.abs(sums[c]));
    }
    return largest;
  }

  /** Source of a node less the mean of its cluster. */
  double balanced(GraphCell cell, int node) {
    return cell.source[node] - means[cell.cluster[node]];
  }

  /** Takes its mean from the solution in each cluster without a fixed side. */
  void centre() {
    Arrays.fill(sums, 0);
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      for (int m = 0; m < cell.nodes; m++) {
        sums[cell.cluster[m]] += cell.solution[m];
      }
    }
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      for (int m = 0; m < cell.nodes; m++) {
        int c = cell.cluster[m];
        cell.solution[m] -= fixed[c] ? 0 : sums[c] / nodes[c];
      }
    }
  }
}
