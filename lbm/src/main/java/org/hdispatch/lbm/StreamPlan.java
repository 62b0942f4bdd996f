package org.hdispatch.lbm;

/**
 * Which slots of the populations the nodes of a bundle stream from and to: for node x and velocity
 * i, the slot opposite to i at the neighbour x - c_i; or, where a wall stands in between, its own
 * slot i (half-way bounce-back). A periodic end leads to a neighbour like any other.
 *
 * <p>That slot holds what arrives at x along i, and in the same step receives what leaves x against
 * i; no other node touches it. So the plan serves all forms of {@link Streaming}.
 *
 * <p>Nodes are described in one of two ways:
 *
 * <ul>
 *   <li>as <em>segments</em>: rows of nodes side by side, whose slots lie side by side too, for
 *       every velocity; several rows at equal distances make one segment. A segment needs one
 *       address a velocity, and is collided where it stands (after Wittmann, Zeiser, Hager,
 *       Wellein, arXiv 1410.0412).
 *   <li>in <em>batches</em> of at most {@link ChunkRows#NODES} nodes, gathered into the worker's
 *       scratch and scattered from there: the nodes at the ends of rows and in narrow pores. A link
 *       is 16 bits; those that lead to another bundle come in groups.
 * </ul>
 *
 * <p>Layout of {@code code}: for each segment, first node, nodes of a row, rows, their pitch, an
 * address a velocity; then for each batch, number of nodes, length in {@code code}, number of
 * {@code links}, and for each velocity the base of its links within the bundle, their number, the
 * number of groups of links that lead elsewhere, and for each group its first address and number.
 * The links of a group are the nodes, then the distances from its first address. The links of
 * velocity 0 are the nodes.
 */
final class StreamPlan {
  /** Bits of an address that are the index; those above are the number of the source. */
  static final int INDEX_BITS = 27;

  /** Numbers of a segment before its addresses: first node, nodes of a row, rows, their pitch. */
  static final int SEGMENT = 4;

  private static final int INDEX = (1 << INDEX_BITS) - 1;

  final int velocities;
  final int segments;
  final int batches;
  final int firstBatch; // in code
  private final NodalBundle[] sources; // 0: the bundle itself
  final int[] code;
  final char[] links;

  StreamPlan(
      int velocities,
      int segments,
      int batches,
      int firstBatch,
      NodalBundle[] sources,
      int[] code,
      char[] links) {
    this.velocities = velocities;
    this.segments = segments;
    this.batches = batches;
    this.firstBatch = firstBatch;
    this.sources = sources;
    this.code = code;
    this.links = links;
  }

  static int address(int source, int index) {
    return source << INDEX_BITS | index;
  }

  static int index(int address) {
    return address & INDEX;
  }

  Populations source(int address, int copy) {
    return sources[address >>> INDEX_BITS].populations(copy);
  }

  Populations own(int copy) {
    return sources[0].populations(copy);
  }

  /** Bytes of the plan. */
  long bytes() {
    return (long) code.length * Integer.BYTES + (long) links.length * Character.BYTES;
  }

  /**
   * Points rows at the slots of a segment.
   *
   * @param at where the segment begins in {@code code}
   */
  void pointAtSegment(Rows rows, int at, int copy, boolean neighbours) {
    if (neighbours) {
      for (int i = 0; i < velocities; i++) {
        int address = code[at + SEGMENT + i];
        rows.point(i, source(address, copy), index(address));
      }
    } else {
      rows.pointAtOwn(own(copy), code[at]);
    }
  }

  /** Length of a segment in {@code code}. */
  int segmentLength() {
    return SEGMENT + velocities;
  }
}
