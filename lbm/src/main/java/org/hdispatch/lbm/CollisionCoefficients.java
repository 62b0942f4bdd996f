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
 *
 * <p>The kernels of all workers of a scheme share one of these. Between two steps the scheme may
 * change the force, and with it {@link #push}, {@link #along}, {@link #forceX}, {@link #forceY} and
 * {@link #forceZ}: a kernel reads those anew in every call.
 */
public final class CollisionCoefficients {
  private final VelocitySet set;
  private final Equilibrium equilibrium;
  private final double halfPlus;
  private final double halfMinus;

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

  private double forceX;
  private double forceY;
  private double forceZ;

  CollisionCoefficients(Collision collision) {
    set = collision.set();
    equilibrium = collision.equilibrium();
    omegaPlus = collision.relaxation().omegaPlus();
    double omegaMinus = collision.relaxation().omegaMinus();
    halfPlus = omegaPlus / 2;
    halfMinus = omegaMinus / 2;
    keepRest = 1 - omegaPlus;
    keep = 1 - halfPlus - halfMinus;
    cross = halfMinus - halfPlus;
    curvature = 4.5 * omegaPlus;
    squares = -1.5 * omegaPlus;
    work = -3 * (1 - halfPlus);
    int pairs = set.pairs();
    even = new double[pairs + 1];
    odd = new double[pairs + 1];
    push = new double[pairs + 1];
    along = new double[pairs + 1];
    double rate = equilibrium == Equilibrium.LINEAR ? omegaPlus : 1;
    even[0] = rate * set.weight(0);
    for (int p = 1; p <= pairs; p++) {
      double w = set.weight(2 * p - 1);
      even[p] = rate * w;
      odd[p] = 3 * w * omegaMinus;
    }
    drive(collision.force());
  }

  /** Changes the force; between two steps only. */
  void drive(BodyForce force) {
    forceX = force.x();
    forceY = force.y();
    forceZ = force.z();
    for (int p = 1; p < push.length; p++) {
      int i = 2 * p - 1;
      double projected = set.cx(i) * forceX + set.cy(i) * forceY + set.cz(i) * forceZ;
      push[p] = (1 - halfMinus) * 3 * set.weight(i) * projected;
      along[p] = (1 - halfPlus) * 9 * projected;
    }
  }

  /** The lattice. */
  public VelocitySet set() {
    return set;
  }

  /** Form of the equilibrium. */
  public Equilibrium equilibrium() {
    return equilibrium;
  }

  /** The force F, first component. */
  public double forceX() {
    return forceX;
  }

  /** The force F, second component. */
  public double forceY() {
    return forceY;
  }

  /** The force F, third component. */
  public double forceZ() {
    return forceZ;
  }
}
