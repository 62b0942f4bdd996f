package org.hdispatch.lbm;

/**
 * Where the populations of a bundle's nodes come from: for each chunk of nodes and each velocity a
 * list of runs, stretches of nodes whose populations also lie side by side at their source.
 *
 * <p>A wall is a source like any other: the opposite population of the node itself (half-way
 * bounce-back). So is a periodic end. Streaming is copying runs, and has no special case.
 *
 * <p>Layout of {@code plan}: for each chunk, for each velocity, the number of runs and then three
 * numbers a run: its length, its source {@code 2 bundle + bounced}, and the first node there.
 */
final class StreamPlan {
  /** Most nodes of a chunk: its rows, populations and moments together, stay in the L1 cache. */
  static final int CHUNK = 128;

  /** Below this length a loop beats {@link System#arraycopy}. */
  private static final int SHORT_RUN = 16;

  private final NodalBundle[] sources;
  private final int[] opposite;
  private final int[] plan;

  StreamPlan(NodalBundle[] sources, VelocitySet set, int[] plan) {
    this.sources = sources;
    opposite = new int[set.size()];
    for (int i = 0; i < opposite.length; i++) {
      opposite[i] = set.opposite(i);
    }
    this.plan = plan;
  }

  /**
   * Streams into the rows of a chunk.
   *
   * @param copy copy of the populations to read
   * @param at where the chunk begins in the plan; 0 for the first
   * @param rows one row a velocity
   * @return where the next chunk begins
   */
  int gather(int copy, int at, double[][] rows) {
    int next = at;
    for (int i = 0; i < rows.length; i++) {
      double[] row = rows[i];
      int runs = plan[next++];
      int to = 0;
      for (int run = 0; run < runs; run++) {
        int length = plan[next];
        int source = plan[next + 1];
        int from = plan[next + 2];
        next += 3;
        int velocity = (source & 1) == 0 ? i : opposite[i];
        double[] populations = sources[source >> 1].populations(copy, velocity);
        if (length < SHORT_RUN) {
          for (int node = 0; node < length; node++) {
            row[to + node] = populations[from + node];
          }
        } else {
          System.arraycopy(populations, from, row, to, length);
        }
        to += length;
      }
    }
    return next;
  }
}
