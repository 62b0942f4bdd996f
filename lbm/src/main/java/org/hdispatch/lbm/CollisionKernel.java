package org.hdispatch.lbm;

/**
 * Collides rows of nodes; the fast and the readable forms of {@link Collision}, bit by bit the
 * same.
 *
 * <p>There are {@code rows} rows of {@code n} nodes, {@code pitch} apart. Population i of node k of
 * row r, before collision and less its weight, stands at {@code in[i][inAt[i] + r pitch + k]}. What
 * leaves the node <em>against</em> velocity i is written to {@code out[i][outAt[i] + r pitch + k]}:
 * each pair of opposite populations changes places, which is what streaming in place asks for.
 * Input and output are either the same places, or do not overlap.
 *
 * <p>A kernel belongs to one worker: it may keep rows of its own between calls. It allocates
 * nothing.
 */
public interface CollisionKernel {
  /** Collides nodes in double precision. */
  void collide(double[][] in, int[] inAt, double[][] out, int[] outAt, int n, int rows, int pitch);

  /** Collides nodes in single precision: every operation is rounded to it. */
  void collide(float[][] in, int[] inAt, float[][] out, int[] outAt, int n, int rows, int pitch);
}
