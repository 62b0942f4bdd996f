package org.hdispatch.lbm;

/**
 * The numbers of a {@link Collision}, multiplied out once so that every form of the kernel computes
 * with the same ones. Per pair p of opposite velocities, c = c_2p-1 and d = rho - 1, j = rho u, v =
 * 1/rho:
 *
 * <pre>
 *   linear     form = d
 *   quadratic  form = (v c.j) (curvature c.j + along[p]) + base
 *              base = omegaPlus d + v (squares j.j + work j.F)
 *   E = even[p] form
 *   O = odd[p] c.j + push[p]
 *   f   becomes (keep f + (cross f' + E)) + O
 *   f'  becomes (keep f' + (cross f + E)) - O
 *   f_0 becomes (1 - omegaPlus) f_0 + even[0] (d or base)
 * </pre>
 *
 * f along c, f' against it. Written so that little more than the populations themselves has to stay
 * in registers.
 */
public final class CollisionCoefficients {
  /** omega+. */
  public final double omegaPlus;

  /** 1 - omega+. */
  public final double keepRest;

  /** 1 - (omega+ + omega-)/2. */
  public final double keep;

  /** (omega- - omega+)/2. */
  public final double cross;

  /** Weight of pair p (0: rest); times omega+ with the linear equilibrium. */
  public final double[] even;

  /** 3 w omega- of pair p. */
  public final double[] odd;

  /** (1 - omega-/2) 3 w c.F of pair p. */
  public final double[] push;

  /** (1 - omega+/2) 9 c.F of pair p. */
  public final double[] along;

  /** 9/2 omega+. */
  public final double curvature;

  /** -3/2 omega+. */
  public final double squares;

  /** -3 (1 - omega+/2). */
  public final double work;

  /** The force F. */
  public final double forceX;

  /** The force F. */
  public final double forceY;

  /** The force F. */
  public final double forceZ;

  CollisionCoefficients(Collision collision) {
    VelocitySet set = collision.set();
    BodyForce force = collision.force();
    omegaPlus = collision.relaxation().omegaPlus();
    double omegaMinus = collision.relaxation().omegaMinus();
    double halfPlus = omegaPlus / 2;
    double halfMinus = omegaMinus / 2;
    keepRest = 1 - omegaPlus;
    keep = 1 - halfPlus - halfMinus;
    cross = halfMinus - halfPlus;
    curvature = 4.5 * omegaPlus;
    squares = -1.5 * omegaPlus;
    work = -3 * (1 - halfPlus);
    forceX = force.x();
    forceY = force.y();
    forceZ = force.z();
    int pairs = set.pairs();
    even = new double[pairs + 1];
    odd = new double[pairs + 1];
    push = new double[pairs + 1];
    along = new double[pairs + 1];
    double rate = collision.equilibrium() == Equilibrium.LINEAR ? omegaPlus : 1;
    even[0] = rate * set.weight(0);
    for (int p = 1; p <= pairs; p++) {
      int i = 2 * p - 1;
      double w = set.weight(i);
      double projected = set.cx(i) * forceX + set.cy(i) * forceY + set.cz(i) * forceZ;
      even[p] = rate * w;
      odd[p] = 3 * w * omegaMinus;
      push[p] = (1 - halfMinus) * 3 * w * projected;
      along[p] = (1 - halfPlus) * 9 * projected;
    }
  }
}
