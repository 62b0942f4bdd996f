package org.hdispatch.lbm;

/**
 * The cell of the lattice Boltzmann method: the fluid nodes of a box of the lattice, with two
 * copies of their populations.
 *
 * <p>Only fluid nodes are stored, x fastest, then y, then z; in a bundle without solid nodes that
 * is the plain order {@code x + nx (y + ny z)}. Shape of a copy: {@code [velocity][node]}, flat,
 * with {@link #stride} numbers from one velocity to the next.
 */
public final class NodalBundle {
  private final long key;
  private final int x0;
  private final int y0;
  private final int z0;
  private final int nx;
  private final int ny;
  private final int[] positions;
  private final double[][] populations;
  private final int stride;
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
    stride = paddedLength(positions.length);
    populations = new double[2][Math.multiplyExact(set.size(), stride)];
  }

  /**
   * Length of a row, lengthened so that one row does not start at the same place of a 4 KiB page as
   * the next: rows that do compete for the same cache sets (16³, 32³ and 64³ nodes are the traps).
   */
  static int paddedLength(int nodes) {
    int least = 200; // bytes
    int page = 4096;
    int place = nodes * Double.BYTES % page;
    int missing = place < least ? least - place : place > page - least ? page + least - place : 0;
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
   * Populations less their weights, after collision. That of velocity i at a node stands at {@code
   * i stride + node}.
   *
   * @param copy {@link org.hdispatch.dispatch.Tick#previous} or {@code current}
   * @return the array itself
   */
  public double[] populations(int copy) {
    return populations[copy];
  }

  /** Numbers from one velocity to the next in {@link #populations}; at least {@link #nodes}. */
  public int stride() {
    return stride;
  }
}
