package org.hdispatch.lbm;

/**
 * Walks through the nodes of a {@link StreamPlan}, chunk by chunk, and moves their populations
 * between the bundles and a worker's scratch. Part of that scratch.
 */
final class ChunkCursor {
  private StreamPlan plan;
  private int at; // of the segment or batch, in the plan
  private int link; // first link of the batch
  private int segmentsLeft; // this one included
  private int batchesLeft;
  private int row; // of the chunk in its segment
  private int offset; // of the chunk in its row
  private int nodes;

  /** Stands before the first chunk. */
  void begin(StreamPlan streamPlan) {
    plan = streamPlan;
    at = 0;
    segmentsLeft = plan.segments;
    batchesLeft = plan.batches + 1;
    link = 0;
    row = 0;
    offset = 0;
    nodes = 0;
  }

  /** Stands before the first batch. */
  void beginBatches(StreamPlan streamPlan) {
    begin(streamPlan);
    segmentsLeft = 0;
    at = plan.firstBatch;
  }

  /** Moves to the next chunk, if there is one. */
  boolean next() {
    while (segmentsLeft > 0) {
      offset += nodes;
      if (offset == plan.code[at + 1]) {
        offset = 0;
        row++;
      }
      nodes = Math.min(ChunkRows.NODES, plan.code[at + 1] - offset);
      if (row < plan.code[at + 2]) {
        return true;
      }
      at += plan.segmentLength();
      row = 0;
      nodes = 0;
      segmentsLeft--;
    }
    if (nodes > 0) {
      link += plan.code[at + 2];
      at += plan.code[at + 1];
    }
    batchesLeft--;
    if (batchesLeft <= 0) {
      return false;
    }
    nodes = plan.code[at];
    return true;
  }

  /** Nodes of the chunk. */
  int nodes() {
    return nodes;
  }

  /** Number of a node of the chunk in its bundle. */
  int node(int k) {
    return segmentsLeft > 0
        ? plan.code[at] + inSegment() + k
        : plan.code[at + 3] + plan.links[link + k];
  }

  /** First node of the chunk, counted from that of its segment. */
  private int inSegment() {
    return row * plan.code[at + 3] + offset;
  }

  /** Reads the chunk's populations into rows, from the neighbours' slots or from their own. */
  void read(int copy, boolean neighbours, ChunkRows rows) {
    if (segmentsLeft > 0) {
      for (int i = 0; i < rows.wide.length; i++) {
        int address = neighbours ? plan.code[at + StreamPlan.SEGMENT + i] : 0;
        Populations from = plan.source(address, copy);
        int index = neighbours ? StreamPlan.index(address) : from.index(i, plan.code[at]);
        from.read(Populations.pair(i), index + inSegment(), rows, i, nodes);
      }
    } else if (neighbours) {
      gather(copy, rows);
    } else {
      Populations own = plan.own(copy);
      int base = plan.code[at + 3];
      for (int i = 0; i < rows.wide.length; i++) {
        int pair = Populations.pair(i);
        own.gather(pair, own.index(i, base), plan.links, link, rows, i, nodes);
      }
    }
  }

  /** Writes rows into the chunk's populations, into the neighbours' slots or into their own. */
  void write(int copy, boolean neighbours, ChunkRows rows) {
    if (segmentsLeft > 0) {
      for (int i = 0; i < rows.wide.length; i++) {
        int address = neighbours ? plan.code[at + StreamPlan.SEGMENT + i] : 0;
        Populations to = plan.source(address, copy);
        int index = neighbours ? StreamPlan.index(address) : to.index(i, plan.code[at]);
        to.write(Populations.pair(i), index + inSegment(), rows, i, nodes);
      }
    } else if (neighbours) {
      scatter(copy, rows);
    } else {
      Populations own = plan.own(copy);
      int base = plan.code[at + 3];
      for (int i = 0; i < rows.wide.length; i++) {
        int pair = Populations.pair(i);
        own.scatter(pair, own.index(i, base), plan.links, link, rows, i, nodes);
      }
    }
  }

  private void gather(int copy, ChunkRows rows) {
    int[] code = plan.code;
    char[] links = plan.links;
    Populations own = plan.own(copy);
    int next = at + 3;
    int from = link;
    for (int i = 0; i < rows.wide.length; i++) {
      int pair = Populations.pair(i);
      int within = code[next + 1];
      own.gather(pair, code[next], links, from, rows, i, within);
      from += within;
      int groups = code[next + 2];
      next += 3;
      for (int group = 0; group < groups; group++) {
        int address = code[next];
        int n = code[next + 1];
        plan.source(address, copy)
            .gatherAt(pair, StreamPlan.index(address), links, from, rows, i, n);
        from += 2 * n;
        next += 2;
      }
    }
  }

  private void scatter(int copy, ChunkRows rows) {
    int[] code = plan.code;
    char[] links = plan.links;
    Populations own = plan.own(copy);
    int next = at + 3;
    int from = link;
    for (int i = 0; i < rows.wide.length; i++) {
      int pair = Populations.pair(i);
      int within = code[next + 1];
      own.scatter(pair, code[next], links, from, rows, i, within);
      from += within;
      int groups = code[next + 2];
      next += 3;
      for (int group = 0; group < groups; group++) {
        int address = code[next];
        int n = code[next + 1];
        plan.source(address, copy)
            .scatterAt(pair, StreamPlan.index(address), links, from, rows, i, n);
        from += 2 * n;
        next += 2;
      }
    }
  }
}
