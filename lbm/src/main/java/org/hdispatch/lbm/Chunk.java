package org.hdispatch.lbm;

/** Length of the rows in which nodes are worked on, and the change of precision on the way. */
final class Chunk {
  /** Most nodes of a chunk: its rows, populations and moments together, stay in the L1 cache. */
  static final int NODES = 128;

  /** Length of a row; see {@link Populations#paddedLength}. */
  static final int PADDED = Populations.paddedLength(NODES, Double.BYTES);

  private Chunk() {}

  /** Copies n numbers from single to double precision. */
  static void widen(float[] from, int fromAt, double[] to, int toAt, int n) {
    for (int k = 0; k < n; k++) {
      to[toAt + k] = from[fromAt + k];
    }
  }

  /** Copies n numbers from double to single precision. */
  static void narrow(double[] from, int fromAt, float[] to, int toAt, int n) {
    for (int k = 0; k < n; k++) {
      to[toAt + k] = (float) from[fromAt + k];
    }
  }
}
