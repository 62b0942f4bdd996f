package org.hdispatch.lbm;

/**
 * One copy of the populations of a bundle's nodes, less their weights.
 *
 * <p>A slot is named by a velocity and a node. The slots of a pair of opposite velocities lie in
 * one array, first those of velocity 2p - 1, then, {@link #stride} later, those of 2p; so a link,
 * which leads from a node either to its own slot or to the opposite one of a neighbour, is one
 * number within one array.
 */
abstract sealed class Populations {
  private final int stride;

  private Populations(int stride) {
    this.stride = stride;
  }

  /** Populations at rest. */
  static Populations of(Storage storage, VelocitySet set, int nodes) {
    int stride = paddedLength(nodes, storage.bytes());
    return storage == Storage.DOUBLE
        ? new InDouble(set.pairs(), stride)
        : new InSingle(set.pairs(), stride);
  }

  /**
   * Length of a row, lengthened so that one row does not start at the same place of a 4 KiB page as
   * the next: rows that do compete for the same cache sets (16³, 32³ and 64³ nodes are the traps).
   */
  static int paddedLength(int nodes, int bytes) {
    int least = 200; // bytes
    int page = 4096;
    int place = (int) ((long) nodes * bytes % page);
    int missing = place < least ? least - place : place > page - least ? page + least - place : 0;
    return nodes + (missing + bytes - 1) / bytes;
  }

  /** Number of the array that holds velocity i. */
  static int pair(int i) {
    return (i + 1) / 2;
  }

  /** Slots from one velocity of a pair to the other. */
  final int stride() {
    return stride;
  }

  /** Index of a slot in its array. */
  final int index(int i, int node) {
    return i > 0 && (i & 1) == 0 ? stride + node : node;
  }

  /** The number in a slot. */
  final double get(int i, int node) {
    return at(pair(i), index(i, node));
  }

  /** Sets a slot. */
  final void set(int i, int node, double value) {
    put(pair(i), index(i, node), value);
  }

  /** The number at an index of an array. */
  abstract double at(int pair, int index);

  /** Sets the number at an index of an array. */
  abstract void put(int pair, int index, double value);

  /** Copies n numbers of an array, from an index on, into row i. */
  abstract void read(int pair, int index, ChunkRows rows, int i, int n);

  /** Copies n numbers of row i into an array, from an index on. */
  abstract void write(int pair, int index, ChunkRows rows, int i, int n);

  /** Reads row i, [k] from base + links[from + k]. */
  abstract void gather(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n);

  /** Writes row i, [k] to base + links[from + k], in order of k. */
  abstract void scatter(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n);

  /** Reads row i, [links[from + m]] from base + links[from + n + m]. */
  abstract void gatherAt(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n);

  /** Writes row i, [links[from + m]] to base + links[from + n + m]. */
  abstract void scatterAt(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n);

  /** Bytes of the arrays. */
  abstract long bytes();

  /** Double precision. */
  static final class InDouble extends Populations {
    /** Array of each pair; that of the population at rest first. */
    final double[][] pairs;

    InDouble(int pairCount, int stride) {
      super(stride);
      pairs = new double[pairCount + 1][];
      for (int p = 0; p <= pairCount; p++) {
        pairs[p] = new double[p == 0 ? stride : Math.multiplyExact(2, stride)];
      }
    }

    private static double[] row(ChunkRows rows, int i) {
      return ((ChunkRows.InDouble) rows).rows[i];
    }

    @Override
    double at(int pair, int index) {
      return pairs[pair][index];
    }

    @Override
    void put(int pair, int index, double value) {
      pairs[pair][index] = value;
    }

    @Override
    void read(int pair, int index, ChunkRows rows, int i, int n) {
      System.arraycopy(pairs[pair], index, row(rows, i), 0, n);
    }

    @Override
    void write(int pair, int index, ChunkRows rows, int i, int n) {
      System.arraycopy(row(rows, i), 0, pairs[pair], index, n);
    }

    @Override
    void gather(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n) {
      double[] row = row(rows, i);
      double[] own = pairs[pair];
      for (int k = 0; k < n; k++) {
        row[k] = own[base + links[from + k]];
      }
    }

    @Override
    void scatter(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n) {
      double[] row = row(rows, i);
      double[] own = pairs[pair];
      for (int k = 0; k < n; k++) {
        own[base + links[from + k]] = row[k];
      }
    }

    @Override
    void gatherAt(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n) {
      double[] row = row(rows, i);
      double[] array = pairs[pair];
      for (int m = from; m < from + n; m++) {
        row[links[m]] = array[base + links[n + m]];
      }
    }

    @Override
    void scatterAt(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n) {
      double[] row = row(rows, i);
      double[] array = pairs[pair];
      for (int m = from; m < from + n; m++) {
        array[base + links[n + m]] = row[links[m]];
      }
    }

    @Override
    long bytes() {
      long numbers = 0;
      for (double[] each : pairs) {
        numbers += each.length;
      }
      return numbers * Double.BYTES;
    }
  }

  /** Single precision. */
  static final class InSingle extends Populations {
    /** Array of each pair; that of the population at rest first. */
    final float[][] pairs;

    InSingle(int pairCount, int stride) {
      super(stride);
      pairs = new float[pairCount + 1][];
      for (int p = 0; p <= pairCount; p++) {
        pairs[p] = new float[p == 0 ? stride : Math.multiplyExact(2, stride)];
      }
    }

    private static float[] row(ChunkRows rows, int i) {
      return ((ChunkRows.InSingle) rows).rows[i];
    }

    @Override
    double at(int pair, int index) {
      return pairs[pair][index];
    }

    @Override
    void put(int pair, int index, double value) {
      pairs[pair][index] = (float) value;
    }

    @Override
    void read(int pair, int index, ChunkRows rows, int i, int n) {
      System.arraycopy(pairs[pair], index, row(rows, i), 0, n);
    }

    @Override
    void write(int pair, int index, ChunkRows rows, int i, int n) {
      System.arraycopy(row(rows, i), 0, pairs[pair], index, n);
    }

    @Override
    void gather(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n) {
      float[] row = row(rows, i);
      float[] own = pairs[pair];
      for (int k = 0; k < n; k++) {
        row[k] = own[base + links[from + k]];
      }
    }

    @Override
    void scatter(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n) {
      float[] row = row(rows, i);
      float[] own = pairs[pair];
      for (int k = 0; k < n; k++) {
        own[base + links[from + k]] = row[k];
      }
    }

    @Override
    void gatherAt(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n) {
      float[] row = row(rows, i);
      float[] array = pairs[pair];
      for (int m = from; m < from + n; m++) {
        row[links[m]] = array[base + links[n + m]];
      }
    }

    @Override
    void scatterAt(int pair, int base, char[] links, int from, ChunkRows rows, int i, int n) {
      float[] row = row(rows, i);
      float[] array = pairs[pair];
      for (int m = from; m < from + n; m++) {
        array[base + links[n + m]] = row[links[m]];
      }
    }

    @Override
    long bytes() {
      long numbers = 0;
      for (float[] each : pairs) {
        numbers += each.length;
      }
      return numbers * Float.BYTES;
    }
  }
}
