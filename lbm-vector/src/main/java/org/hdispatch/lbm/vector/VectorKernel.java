package org.hdispatch.lbm.vector;

import org.hdispatch.lbm.CollisionKernel;
import org.hdispatch.lbm.VelocitySet;

/**
 * What the kernels have in common: nodes stored in single precision, which are changed to double in
 * chunks that stay in the L1 cache. (Changing them within the kernels' one loop makes it too large
 * for C2 to compile without boxing vectors: a fifth of the speed.)
 */
abstract class VectorKernel implements CollisionKernel {
  private static final int CHUNK = 128;
  private static final int PADDING = 24; // so that rows do not compete for the same cache sets

  private final double[][] chunk;
  private final int[] start;

  VectorKernel(VelocitySet set) {
    chunk = new double[set.size()][CHUNK + PADDING];
    start = new int[set.size()];
  }

  @Override
  public final void collide(
      float[][] in, int[] inAt, float[][] out, int[] outAt, int n, int rows, int pitch) {
    for (int row = 0; row < rows; row++) {
      for (int first = 0; first < n; first += CHUNK) {
        int nodes = Math.min(CHUNK, n - first);
        int from = row * pitch + first;
        for (int i = 0; i < start.length; i++) {
          Lanes.widen(in[i], inAt[i] + from, chunk[i], nodes);
        }
        collide(chunk, start, chunk, start, nodes, 1, 0);
        for (int i = 0; i < start.length; i++) {
          Lanes.narrow(chunk[i], out[i], outAt[i] + from, nodes);
        }
      }
    }
  }
}
