package org.hdispatch.lbm;

import java.util.Arrays;

/**
 * Where the fluid nodes of a box lie: runs of consecutive positions {@code x + nx (y + ny z)}, for
 * there are many fewer runs than nodes.
 */
final class NodeRuns {
  private final int nodes;
  private final int[] firstNode;
  private final int[] firstPosition;

  /**
   * Finds the runs.
   *
   * @param positions of the fluid nodes, increasing
   * @param count how many of them there are
   */
  NodeRuns(int[] positions, int count) {
    nodes = count;
    int[] first = new int[count];
    int runs = 0;
    for (int node = 0; node < count; node++) {
      if (node == 0 || positions[node] != positions[node - 1] + 1) {
        first[runs++] = node;
      }
    }
    firstNode = Arrays.copyOf(first, runs);
    firstPosition = new int[runs];
    for (int run = 0; run < runs; run++) {
      firstPosition[run] = positions[first[run]];
    }
  }

  int nodes() {
    return nodes;
  }

  /** Position of a node. */
  int position(int node) {
    return position(node, run(node));
  }

  private int run(int node) {
    int found = Arrays.binarySearch(firstNode, node);
    return found >= 0 ? found : -found - 2;
  }

  /**
   * Number of the run that a node lies in.
   *
   * @param guess number of a run: that of the node before, when nodes are asked for in order
   */
  int run(int node, int guess) {
    int run = node < firstNode[guess] ? run(node) : guess;
    while (run + 1 < firstNode.length && node >= firstNode[run + 1]) {
      run++;
    }
    return run;
  }

  /** Position of a node of a run. */
  int position(int node, int run) {
    return firstPosition[run] + node - firstNode[run];
  }

  /** Writes the positions of all nodes, in order. */
  void positions(int[] to) {
    for (int run = 0; run < firstNode.length; run++) {
      int end = run + 1 < firstNode.length ? firstNode[run + 1] : nodes;
      for (int node = firstNode[run]; node < end; node++) {
        to[node] = firstPosition[run] + node - firstNode[run];
      }
    }
  }

  /**
   * Writes which nodes lie at n positions from one on, or {@code none}.
   *
   * @param to where they are written, from index {@code at} on
   */
  void nodesAt(int position, int n, int none, int[] to, int at) {
    Arrays.fill(to, at, at + n, none);
    int found = Arrays.binarySearch(firstPosition, position);
    for (int run = Math.max(found >= 0 ? found : -found - 2, 0); run < firstNode.length; run++) {
      int first = firstPosition[run] - position; // of the run, counted from the first position
      if (first >= n) {
        return;
      }
      int length = (run + 1 < firstNode.length ? firstNode[run + 1] : nodes) - firstNode[run];
      for (int k = Math.max(first, 0); k < Math.min(first + length, n); k++) {
        to[at + k] = firstNode[run] + k - first;
      }
    }
  }

  long bytes() {
    return 2L * firstNode.length * Integer.BYTES;
  }
}
