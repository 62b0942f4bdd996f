package org.hdispatch.lbm;

import java.util.Objects;

/**
 * What happens to the populations of a node: two relaxation times (BGK is the case of equal rates)
 * under a body force.
 *
 * <p>With s and a the sum and the difference of a pair of opposite populations, less their weights:
 *
 * <pre>
 *   rho u = sum_i c_i f_i + F/2
 *   S = -omega+/2 (s - s_eq) + (1 - omega+/2) w (9 (c.u)(c.F) - 3 u.F)     F with the quadratic equilibrium only
 *   A = -omega-/2 (a - a_eq) + (1 - omega-/2) w 3 c.F
 *   f  += S + A        along c
 *   f' += S - A        against c
 * </pre>
 *
 * (Guo, Zheng, Shi, Physical Review E 65, 2002, 046308, split into even and odd parts). Mass is
 * conserved node by node. F = g: the force per volume of a fluid of mean density 1.
 *
 * @param set the lattice
 * @param relaxation the relaxation rates
 * @param equilibrium form of the equilibrium
 * @param force body force
 */
public record Collision(
    VelocitySet set, Relaxation relaxation, Equilibrium equilibrium, BodyForce force) {
  /** Checks that nothing is missing. */
  public Collision {
    Objects.requireNonNull(set, "set");
    Objects.requireNonNull(relaxation, "relaxation");
    Objects.requireNonNull(equilibrium, "equilibrium");
    Objects.requireNonNull(force, "force");
  }

  /** The numbers of the formulas, multiplied out; made anew. */
  public CollisionCoefficients coefficients() {
    return new CollisionCoefficients(this);
  }
}
