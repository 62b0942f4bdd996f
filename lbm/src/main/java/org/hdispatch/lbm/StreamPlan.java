package org.hdispatch.lbm;

/**
 * Where the populations of a bundle's nodes come from, chunk by chunk and velocity by velocity.
 *
 * <p>A wall is a source like any other: the opposite population of the node itself (half-way
 * bounce-back). So is a periodic end. Streaming is copying, and has no special case.
 *
 * <p>A row of a chunk is described in one of two ways, whichever is shorter to follow:
 *
 * <ul>
 *   <li>as <em>runs</em>, stretches of nodes whose populations also lie side by side at their
 *       source: the number of runs, then for each its length, source bundle and first index;
 *   <li>as <em>links</em>: -1, one index per node into the bundle's own populations, then the
 *       number of links that lead to another bundle, and for each its node, source bundle and
 *       index.
 * </ul>
 *
 * Runs serve open spaces, links serve narrow pores, where a run is a few nodes long and its end is
 * a branch that no processor predicts.
 */
final class StreamPlan {
  /** Most nodes of a chunk: its rows, populations and moments together, stay in the L1 cache. */
  static final int CHUNK = 128;

  /** Mark of a row described as links. */
  static final int LINKS = -1;

  private final NodalBundle[] sources; // 0: the bundle itself
  private final int[] plan;

  StreamPlan(NodalBundle[] sources, int[] plan) {
    this.sources = sources;
    this.plan = plan;
  }

  /**
   * Streams into the rows of a chunk.
   *
   * @param copy copy of the populations to read
   * @param at where the chunk begins in the plan; 0 for the first
   * @param nodes nodes of the chunk
   * @param rows one row a velocity
   * @return where the next chunk begins
   */
  int gather(int copy, int at, int nodes, double[][] rows) {
    int next = at;
    for (double[] row : rows) {
      int kind = plan[next++];
      next = kind == LINKS ? followLinks(copy, next, nodes, row) : copyRuns(copy, next, kind, row);
    }
    return next;
  }

  private int copyRuns(int copy, int at, int runs, double[] row) {
    int next = at;
    int to = 0;
    for (int run = 0; run < runs; run++) {
      int length = plan[next];
      System.arraycopy(sources[plan[next + 1]].populations(copy), plan[next + 2], row, to, length);
      to += length;
      next += 3;
    }
    return next;
  }

  private int followLinks(int copy, int at, int nodes, double[] row) {
    double[] own = sources[0].populations(copy);
    for (int node = 0; node < nodes; node++) {
      row[node] = own[plan[at + node]];
    }
    int next = at + nodes;
    int outside = plan[next++];
    for (int link = 0; link < outside; link++) {
      row[plan[next]] = sources[plan[next + 1]].populations(copy)[plan[next + 2]];
      next += 3;
    }
    return next;
  }
}
