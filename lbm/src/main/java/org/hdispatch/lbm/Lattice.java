package org.hdispatch.lbm;

import java.util.Objects;
import org.hdispatch.cell.Ends;

/**
 * A box of nodes, some of them solid. Half-way bounce-back walls stand between fluid and solid
 * nodes, and at those ends of the box that are not periodic and to which the scheme gives no faces.
 *
 * <p>A diagonal link is open only if its two nodes also connect face by face, through fluid nodes,
 * within the small box that the link spans: fluid does not slip through the corner where two solid
 * nodes touch. So the flow respects the same 6-connected clusters as percolation does.
 *
 * @param nx nodes along x
 * @param ny nodes along y
 * @param nz nodes along z
 * @param x ends along x: {@code OPEN} is a wall or a face
 * @param y ends along y: {@code OPEN} is a wall or a face
 * @param z ends along z: {@code OPEN} is a wall or a face
 * @param nodes which nodes are fluid
 */
public record Lattice(int nx, int ny, int nz, Ends x, Ends y, Ends z, NodeMap nodes) {
  /**
   * Checks the extents, and that nothing is missing.
   *
   * @throws IllegalArgumentException if an extent is less than 1
   */
  public Lattice {
    if (nx < 1 || ny < 1 || nz < 1) {
      throw new IllegalArgumentException(
          "nodes along an axis must number at least 1: nx=" + nx + ", ny=" + ny + ", nz=" + nz);
    }
    Objects.requireNonNull(x, "x");
    Objects.requireNonNull(y, "y");
    Objects.requireNonNull(z, "z");
    Objects.requireNonNull(nodes, "nodes");
  }

  /** A box without solid nodes. */
  public static Lattice empty(int nx, int ny, int nz, Ends x, Ends y, Ends z) {
    return new Lattice(nx, ny, nz, x, y, z, (i, j, k) -> true);
  }

  /** Whether there is fluid at (i, j, k), which may lie outside the box. */
  public boolean fluid(int i, int j, int k) {
    int xi = x.wrap(i, nx);
    int yj = y.wrap(j, ny);
    int zk = z.wrap(k, nz);
    return xi >= 0 && yj >= 0 && zk >= 0 && nodes.fluid(xi, yj, zk);
  }
}
