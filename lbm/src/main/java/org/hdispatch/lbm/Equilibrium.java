package org.hdispatch.lbm;

/** The equilibrium populations of a density and a velocity. */
public enum Equilibrium {
  /**
   * f_i = w_i rho (1 + 3 c.u + 9/2 (c.u)² - 3/2 u²): the Navier-Stokes equations at small Mach
   * number (Qian et al. 1992).
   */
  QUADRATIC,
  /**
   * f_i = w_i (rho + 3 c.u), with u the momentum: the Stokes equations; the flow is proportional to
   * the force at any force.
   */
  LINEAR;

  /**
   * Population i less its weight, f_i - w_i.
   *
   * @param set the lattice
   * @param i number of the velocity
   * @param density rho
   */
  public double deviation(VelocitySet set, int i, double density, double ux, double uy, double uz) {
    double cu = set.cx(i) * ux + set.cy(i) * uy + set.cz(i) * uz;
    double w = set.weight(i);
    if (this == LINEAR) {
      return w * (density - 1 + 3 * cu);
    }
    double squares = 4.5 * cu * cu - 1.5 * (ux * ux + uy * uy + uz * uz);
    return w * (density - 1 + density * (3 * cu + squares));
  }
}
