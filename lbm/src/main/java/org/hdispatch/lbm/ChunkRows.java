package org.hdispatch.lbm;

/**
 * The populations of a chunk of nodes in a worker's scratch: a row for each velocity, in the
 * precision in which they are stored.
 */
abstract sealed class ChunkRows {
  /** Most nodes of a chunk: its rows stay in the L1 cache. */
  static final int NODES = 128;

  /** The rows in double precision: themselves, or what {@link #widen} and {@link #narrow} copy. */
  final double[][] wide;

  private ChunkRows(int velocities) {
    wide = new double[velocities][Populations.paddedLength(NODES, Double.BYTES)];
  }

  /** Rows that hold rubbish. */
  static ChunkRows of(Storage storage, int velocities) {
    return storage == Storage.DOUBLE ? new InDouble(velocities) : new InSingle(velocities);
  }

  /** Makes {@link #wide} what the rows are. */
  abstract void widen(int n);

  /** Makes the rows what {@link #wide} is, rounded. */
  abstract void narrow(int n);

  /** Collides the nodes where they stand. */
  abstract void collide(CollisionKernel kernel, int n);

  /** Double precision. */
  static final class InDouble extends ChunkRows {
    /** Row of each velocity. */
    final double[][] rows;

    private final int[] start;

    private InDouble(int velocities) {
      super(velocities);
      rows = wide;
      start = new int[velocities];
    }

    @Override
    void widen(int n) {}

    @Override
    void narrow(int n) {}

    @Override
    void collide(CollisionKernel kernel, int n) {
      kernel.collide(rows, start, rows, start, n, 1, 0);
    }
  }

  /** Single precision. */
  static final class InSingle extends ChunkRows {
    /** Row of each velocity. */
    final float[][] rows;

    private final int[] start;

    private InSingle(int velocities) {
      super(velocities);
      rows = new float[velocities][Populations.paddedLength(NODES, Float.BYTES)];
      start = new int[velocities];
    }

    @Override
    void widen(int n) {
      for (int i = 0; i < rows.length; i++) {
        float[] from = rows[i];
        double[] to = wide[i];
        for (int k = 0; k < n; k++) {
          to[k] = from[k];
        }
      }
    }

    @Override
    void narrow(int n) {
      for (int i = 0; i < rows.length; i++) {
        double[] from = wide[i];
        float[] to = rows[i];
        for (int k = 0; k < n; k++) {
          to[k] = (float) from[k];
        }
      }
    }

    @Override
    void collide(CollisionKernel kernel, int n) {
      kernel.collide(rows, start, rows, start, n, 1, 0);
    }
  }
}
