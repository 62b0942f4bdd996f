package org.hdispatch.sph;

/**
 * What the particles of a cell sum up over their neighbours: the inner loops of the method.
 *
 * <p>Each particle sums over all its neighbours, so that nobody writes what others write. A sum
 * runs over the quads of its list in order, in {@link Neighbourhood#LANES} partial sums s0 to s3,
 * added at the end as (s0 + s1) + (s2 + s3). All forms of this keep that order and the same fused
 * operations, and are bit-equal.
 *
 * <p>One for each worker: it may keep scratch. Nothing is allocated once that has grown.
 */
public interface PairSums {
  /** Added to r^2, so that a particle is its own neighbour at a distance that can be divided by. */
  double LEAST_SQUARE = 1e-300;

  /**
   * Lists, for each of the cell's own particles, the quads with a particle closer than the reach.
   *
   * @param near positions
   * @param reach in the unit of length
   * @param list where they go
   */
  void search(Neighbourhood near, double reach, NeighbourList list);

  /**
   * Number density n_i = sum_j W(r_ij), the particle itself included.
   *
   * @param near positions
   * @param list the neighbours of the cell's own particles
   * @param density where n goes, by own particle
   */
  void density(Neighbourhood near, NeighbourList list, double[] density);

  /**
   * Force on each fluid particle by pressure and, over the share s_i of {@link PairModel#share}, by
   * viscosity,
   *
   * <pre>
   * f_i = sum_j [ m_ij b_ij (v_i - v_j)/(n_i n_j s_i) - (P_i/n_i^2 + P_j/n_j^2) (r_i - r_j) ]
   *     (dW/dr)/r
   * </pre>
   *
   * <p>so that, with all other forces g_i per mass, the particle is accelerated by s_i (f_i/m_i +
   * g_i).
   *
   * <p>with m_ij = mu_i + mu_j or 4/(1/mu_i + 1/mu_j) (Tartakovsky, Meakin 2005; Hu, Adams 2006;
   * Morris et al. 1997). At a wall the velocity is carried on into the solid, so that it vanishes
   * on the surface: b_ij = min(beta_max, 1 + d_j/d_i), d_i being the distance of the fluid particle
   * from the wall and d_j the depth of the solid one; elsewhere it is 1. The share carries it on
   * along a parabola.
   *
   * @param near all planes that the {@link PairModel} asks for
   * @param list the neighbours of the cell's own particles
   * @param x where the force along x goes, by own fluid particle
   * @param y where the force along y goes
   * @param z where the force along z goes
   * @param share where s goes; it is 1 where there are no walls
   */
  void force(
      Neighbourhood near, NeighbourList list, double[] x, double[] y, double[] z, double[] share);
}
