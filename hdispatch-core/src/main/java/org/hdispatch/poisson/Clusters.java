package org.hdispatch.poisson;

import java.util.Arrays;
import java.util.function.Consumer;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Dispatcher;

/**
 * The clusters of nodes that links connect. One without a fixed side knows its solution up to a
 * constant only, and has one at all only if its sources add up to 0.
 *
 * <p>Workers find the clusters within each cell; the caller joins those of different cells. Sums
 * over a cluster are added in the same way, so that their bits depend on no worker.
 */
final class Clusters {
  private final CellMap<GraphCell> cells;
  private final int count;
  private final long[] nodes;
  private final boolean[] fixed;
  private final double[] sums;
  private final double[] means; // of what is balanced; 0 where a side is fixed
  private final Consumer<GraphCell> sumSources = cell -> sum(cell, cell.source);
  private final Consumer<GraphCell> sumSolution = cell -> sum(cell, cell.solution);
  private final Consumer<GraphCell> centre = this::centre;

  Clusters(Dispatcher dispatcher, CellMap<GraphCell> cells) {
    this.cells = cells;
    int most = 0;
    for (int n = 0; n < cells.size(); n++) {
      most = Math.max(most, cells.cellAt(n).nodes);
    }
    int ofLargest = most;
    Passes.once(dispatcher, cells, () -> new int[ofLargest], Clusters::find);
    int[] parent = joined();
    count = number(parent);
    nodes = new long[count];
    fixed = new boolean[count];
    sums = new double[count];
    means = new double[count];
    Passes.once(dispatcher, cells, () -> null, (cell, none) -> countNodes(cell));
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      for (int c = 0; c < cell.clusters.length; c++) {
        nodes[cell.clusters[c]] += (long) cell.clusterSums[c];
        fixed[cell.clusters[c]] |= cell.clusterFixed[c];
      }
    }
  }

  /** Finds the clusters within a cell, in the order of their first nodes. */
  private static void find(GraphCell cell, int[] parent) {
    for (int m = 0; m < cell.nodes; m++) {
      parent[m] = m;
    }
    Links links = cell.upper;
    for (int m = 0; m < cell.nodes; m++) {
      for (int n = links.begin(m); n < links.end(m); n++) {
        join(parent, m, links.to()[n]);
      }
    }
    cell.cluster = new char[cell.nodes];
    int next = 0;
    for (int m = 0; m < cell.nodes; m++) {
      int root = root(parent, m);
      cell.cluster[m] = root == m ? (char) next++ : cell.cluster[root];
    }
    cell.clusters = new int[next];
    cell.clusterSums = new double[next];
    cell.clusterFixed = new boolean[next];
  }

  /** Joins those that links to other cells connect; each has a number of its own so far. */
  private int[] joined() {
    int all = 0;
    for (int n = 0; n < cells.size(); n++) {
      int[] numbers = cells.cellAt(n).clusters;
      for (int c = 0; c < numbers.length; c++) {
        numbers[c] = all;
        all = Math.addExact(all, 1);
      }
    }
    int[] parent = new int[all];
    Arrays.setAll(parent, n -> n);
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      HaloLinks halo = cell.halo;
      for (int c = 0, link = 0; c < halo.cells().length; c++) {
        GraphCell other = halo.cells()[c];
        for (; link < halo.end()[c]; link++) {
          int here = cell.clusters[cell.cluster[halo.row()[link]]];
          join(parent, here, other.clusters[other.cluster[halo.to()[link]]]);
        }
      }
    }
    return parent;
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

  /** Numbers the clusters in the order of their first nodes, and tells every cell its own. */
  private int number(int[] parent) {
    int next = 0;
    int[] numbers = new int[parent.length];
    for (int n = 0; n < cells.size(); n++) {
      int[] own = cells.cellAt(n).clusters;
      for (int c = 0; c < own.length; c++) {
        int root = root(parent, own[c]);
        if (root == own[c]) {
          numbers[root] = next++;
        }
        own[c] = numbers[root];
      }
    }
    return next;
  }

  private static void countNodes(GraphCell cell) {
    for (int m = 0; m < cell.nodes; m++) {
      cell.clusterSums[cell.cluster[m]]++;
      cell.clusterFixed[cell.cluster[m]] |= cell.ground != null && cell.ground[m] > 0;
    }
  }

  int count() {
    return count;
  }

  /**
   * Finds the mean source of each cluster without a fixed side.
   *
   * @return the largest |sum of sources| of such a cluster
   */
  double balance(Level level) {
    level.run(sumSources);
    return findMeans();
  }

  /** Source of a node less the mean of its cluster. */
  double balanced(GraphCell cell, int node) {
    return cell.source[node] - means[cell.clusters[cell.cluster[node]]];
  }

  /** Takes its mean from the solution in each cluster without a fixed side. */
  void centre(Level level) {
    level.run(sumSolution);
    findMeans();
    level.run(centre);
  }

  private void centre(GraphCell cell) {
    for (int m = 0; m < cell.nodes; m++) {
      cell.solution[m] -= means[cell.clusters[cell.cluster[m]]];
    }
  }

  private static void sum(GraphCell cell, double[] values) {
    Arrays.fill(cell.clusterSums, 0);
    for (int m = 0; m < cell.nodes; m++) {
      cell.clusterSums[cell.cluster[m]] += values[m];
    }
  }

  /** From the sums of the cells: the means, and the largest of the |sums|. */
  private double findMeans() {
    Arrays.fill(sums, 0);
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      for (int c = 0; c < cell.clusters.length; c++) {
        sums[cell.clusters[c]] += cell.clusterSums[c];
      }
    }
    double largest = 0;
    for (int c = 0; c < count; c++) {
      means[c] = fixed[c] ? 0 : sums[c] / nodes[c];
      largest = fixed[c] ? largest : Math.max(largest, Math.abs(sums[c]));
    }
    return largest;
  }
}
