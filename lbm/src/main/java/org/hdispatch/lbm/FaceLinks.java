package org.hdispatch.lbm;

/**
 * The links of the nodes of one bundle that pass through {@link Faces}. What arrives at node a
 * along velocity i comes from the slot of velocity j of a node b: that beside a to which the
 * mirrored link leads. What arrives at b along j comes from slot i of a. So one exchange serves
 * both, and one of their bundles makes it.
 */
final class FaceLinks {
  /** Those of a bundle without such nodes. */
  static final FaceLinks NONE = new FaceLinks(null, new NodalBundle[0], new int[0]);

  /** Numbers of a link: node, {@link #pack}, address of the other slot. */
  static final int LENGTH = 3;

  private static final int VELOCITY_BITS = 8;
  private static final int VELOCITY = (1 << VELOCITY_BITS) - 1;

  private final Faces faces;
  private final NodalBundle[] sources; // 0: the bundle itself
  private final int[] code; // by node, increasing

  FaceLinks(Faces faces, NodalBundle[] sources, int[] code) {
    this.faces = faces;
    this.sources = sources;
    this.code = code;
  }

  /**
   * Packs what a link is.
   *
   * @param own whether this bundle makes the exchange
   */
  static int pack(int i, int j, int kind, boolean own) {
    return i | j << VELOCITY_BITS | kind << 2 * VELOCITY_BITS | (own ? Integer.MIN_VALUE : 0);
  }

  private static int velocity(int packed) {
    return packed & VELOCITY;
  }

  private static int otherVelocity(int packed) {
    return packed >>> VELOCITY_BITS & VELOCITY;
  }

  private static int kind(int packed) {
    return packed >>> 2 * VELOCITY_BITS & VELOCITY;
  }

  /** Turns what has left through the faces into what arrives there, for the links it owns. */
  void exchange(int copy) {
    for (int at = 0; at < code.length; at += LENGTH) {
      int packed = code[at + 1];
      if (packed < 0) {
        exchange(copy, code[at], packed, code[at + 2]);
      }
    }
  }

  private void exchange(int copy, int node, int packed, int address) {
    Populations own = sources[0].populations(copy);
    Populations other = sources[address >>> StreamPlan.INDEX_BITS].populations(copy);
    int i = velocity(packed);
    int pair = Populations.pair(otherVelocity(packed));
    int index = StreamPlan.index(address);
    double here = own.get(i, node);
    double there = other.at(pair, index);
    own.set(i, node, faces.arriving(kind(packed), i, there));
    other.put(pair, index, faces.arriving(kind(packed), i, here));
  }

  /** Puts what will arrive through the faces at the nodes of a chunk into its rows. */
  void arrive(int copy, ChunkCursor chunk, double[][] rows) {
    for (int k = 0; k < chunk.nodes() && code.length > 0; k++) {
      int node = chunk.node(k);
      for (int at = find(node); at < code.length && code[at] == node; at += LENGTH) {
        int packed = code[at + 1];
        int address = code[at + 2];
        double there =
            sources[address >>> StreamPlan.INDEX_BITS]
                .populations(copy)
                .at(Populations.pair(otherVelocity(packed)), StreamPlan.index(address));
        int i = velocity(packed);
        rows[i][k] = faces.arriving(kind(packed), i, there);
      }
    }
  }

  /** Where the first link of a node stands, or of the next that has one. */
  private int find(int node) {
    int low = 0;
    int high = code.length / LENGTH;
    while (low < high) {
      int middle = (low + high) / 2;
      if (code[LENGTH * middle] < node) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return LENGTH * low;
  }

  long bytes() {
    return (long) code.length * Integer.BYTES;
  }
}
