package org.hdispatch.lbm;

/** Where a row of nodes has its populations: an array and an index for each velocity. */
abstract sealed class Rows {
  /** Index of the first node, for each velocity. */
  final int[] at;

  private Rows(int velocities) {
    at = new int[velocities];
  }

  /** Rows that point nowhere yet. */
  static Rows of(Storage storage, int velocities) {
    return storage == Storage.DOUBLE ? new InDouble(velocities) : new InSingle(velocities);
  }

  /** Points velocity i at an index of the array that holds it and its opposite. */
  abstract void point(int i, Populations to, int index);

  /** Collides rows of n nodes, a pitch apart, from these places to others. */
  abstract void collide(CollisionKernel kernel, Rows to, int n, int rows, int pitch);

  /** Points all velocities at their own slots, from a node on. */
  final void pointAtOwn(Populations own, int node) {
    for (int i = 0; i < at.length; i++) {
      point(i, own, own.index(i, node));
    }
  }

  private static final class InDouble extends Rows {
    private final double[][] arrays;

    InDouble(int velocities) {
      super(velocities);
      arrays = new double[velocities][];
    }

    @Override
    void point(int i, Populations to, int index) {
      double[] array = ((Populations.InDouble) to).pairs[Populations.pair(i)];
      if (arrays[i] != array) { // most point there already, and storing a reference costs a barrier
        arrays[i] = array;
      }
      at[i] = index;
    }

    @Override
    void collide(CollisionKernel kernel, Rows to, int n, int rows, int pitch) {
      kernel.collide(arrays, at, ((InDouble) to).arrays, to.at, n, rows, pitch);
    }
  }

  private static final class InSingle extends Rows {
    private final float[][] arrays;

    InSingle(int velocities) {
      super(velocities);
      arrays = new float[velocities][];
    }

    @Override
    void point(int i, Populations to, int index) {
      float[] array = ((Populations.InSingle) to).pairs[Populations.pair(i)];
      if (arrays[i] != array) { // most point there already, and storing a reference costs a barrier
        arrays[i] = array;
      }
      at[i] = index;
    }

    @Override
    void collide(CollisionKernel kernel, Rows to, int n, int rows, int pitch) {
      kernel.collide(arrays, at, ((InSingle) to).arrays, to.at, n, rows, pitch);
    }
  }
}
