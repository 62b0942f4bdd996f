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
    Arrays.setAll(firstPosition, run -> positions[firstNode[run]]);
  }

  int nodes() {
    return nodes;
  }

  /** Position of a node. */
  int position(int node) {
    int found = Arrays.binarySearch(firstNode, node);
    int run = found >= 0 ? found : -found - 2;
    return firstPosition[run] + node - firstNode[run];
  }

  long bytes() {
    return 2L * firstNode.length * Integer.BYTES;
  }
}
