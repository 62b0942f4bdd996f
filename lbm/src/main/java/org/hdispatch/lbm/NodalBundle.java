package org.hdispatch.lbm;

/**
 * The cell of the lattice Boltzmann method: the fluid nodes of a box of the lattice, with two
 * copies of their populations.
 *
 * <p>Only fluid nodes are stored, x fastest, then y, then z; in a bundle without solid nodes that
 * is the plain order {@code x + nx (y + ny z)}. Shape: {@code populations[copy][velocity][node]}.
 */
public final class NodalBundle {
  private final long key;
  private final int x0;
  private final int y0;
  private final int z0;
  private final int nx;
  private final int ny;
  private final int[] positions;
  private final double[][][] populations;
  private StreamPlan plan;

  /**
   * Makes a bundle with all populations at rest.
   *
   * @param positions {@code x + nx (y + ny z)} of each fluid node within the box, increasing
   */
  NodalBundle(long key, int x0, int y0, int z0, int nx, int ny, int[] positions, VelocitySet set) {
    this.key = key;
    this.x0 = x0;
    this.y0 = y0;
    this.z0 = z0;
    this.nx = nx;
    this.ny = ny;
    this.positions = positions;
    populations = new double[2][set.size()][paddedLength(positions.length)];
  }

  /**
   * Length of a row that keeps consecutive rows from starting at the same place of a 4 KiB page:
   * rows that do compete for the same cache sets (a third of the speed at 16³, 32³, 64³ nodes).
   */
  static int paddedLength(int nodes) {
    int stride = (nodes * Double.BYTES + 16) % 4096; // 16: header of a Java array
    int missing = stride < 200 ? 200 - stride : stride > 3896 ? 4096 + 200 - stride : 0;
    return nodes + (missing + Double.BYTES - 1) / Double.BYTES;
  }

  void link(StreamPlan streamPlan) {
    plan = streamPlan;
  }

  StreamPlan plan() {
    return plan;
  }

  /** Key of this bundle: its coordinates among the bundles. */
  public long key() {
    return key;
  }

  /** Number of fluid nodes. */
  public int nodes() {
    return positions.length;
  }

  /** First coordinate of a node in the lattice. */
  public int x(int node) {
    return x0 + positions[node] % nx;
  }

  /** Second coordinate of a node in the lattice. */
  public int y(int node) {
    return y0 + positions[node] / nx % ny;
  }

  /** Third coordinate of a node in the lattice. */
  public int z(int node) {
    return z0 + positions[node] / (nx * ny);
  }

  /**
   * Populations of one velocity, less its weight, after collision.
   *
   * @param copy {@link org.hdispatch.dispatch.Tick#previous} or {@code current}
   * @param velocity number of the velocity
   * @return the row itself; it may be longer than {@link #nodes}
   */
  public double[] populations(int copy, int velocity) {
    return populations[copy][velocity];
  }
}
