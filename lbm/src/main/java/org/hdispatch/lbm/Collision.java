package org.hdispatch.lbm;

import java.util.Objects;

/**
 * Collides rows of nodes in place, pair of opposite populations by pair (two relaxation times; BGK
 * is the case of equal rates), under a body force.
 *
 * <p>With s and a the symmetric and antisymmetric halves of a pair, both less their weights:
 *
 * <pre>
 *   s += -omega+ (s - s_eq) + (1 - omega+/2) w (9 (c.u)(c.F) - 3 u.F)     quadratic equilibrium only
 *   a += -omega- (a - a_eq) + (1 - omega-/2) w 3 c.F
 *   rho u = sum_i c_i f_i + F/2
 * </pre>
 *
 * (Guo, Zheng, Shi, Physical Review E 65, 2002, 046308, split into even and odd parts). Mass is
 * conserved node by node. F = g: the force per volume of a fluid of mean density 1.
 */
final class Collision {
  private final VelocitySet set;
  private final Relaxation relaxation;
  private final Equilibrium equilibrium;
  private final BodyForce force;

  Collision(VelocitySet set, Relaxation relaxation, Equilibrium equilibrium, BodyForce force) {
    this.set = Objects.requireNonNull(set, "set");
    this.relaxation = Objects.requireNonNull(relaxation, "relaxation");
    this.equilibrium = Objects.requireNonNull(equilibrium, "equilibrium");
    this.force = Objects.requireNonNull(force, "force");
  }

  /**
   * Collides {@code n} nodes.
   *
   * @param f rows of populations before collision, less their weights; overwritten
   * @param m rows for the moments; overwritten
   */
  void collide(double[][] f, MomentRows m, int n) {
    m.sum(set, f, n);
    m.addToMomentum(force.x() / 2, force.y() / 2, force.z() / 2, n);
    if (equilibrium == Equilibrium.LINEAR) {
      collideLinear(f, m, n);
    } else {
      m.momentumToVelocity(n);
      collideQuadratic(f, m, n);
    }
  }

  private void collideLinear(double[][] f, MomentRows m, int n) {
    double plus = relaxation.omegaPlus();
    double minus = relaxation.omegaMinus();
    relaxRest(f[0], m.density, plus, set.weight(0), n);
    for (int i = 1; i < f.length; i += 2) {
      double x = set.cx(i);
      double y = set.cy(i);
      double z = set.cz(i);
      double w = set.weight(i);
      double push = (1 - minus / 2) * w * 3 * (x * force.x() + y * force.y() + z * force.z());
      project(m.along, m.x, m.y, m.z, 3 * w * x, 3 * w * y, 3 * w * z, n);
      relaxPair(f[i], f[i + 1], m.density, m.along, w, plus / 2, minus / 2, push, n);
    }
  }

  private void collideQuadratic(double[][] f, MomentRows m, int n) {
    double plus = relaxation.omegaPlus();
    double minus = relaxation.omegaMinus();
    double forced = 1 - plus / 2;
    square(m, n);
    relaxRestQuadratic(f[0], m, set.weight(0), plus, forced, n);
    for (int i = 1; i < f.length; i += 2) {
      double x = set.cx(i);
      double y = set.cy(i);
      double z = set.cz(i);
      double w = set.weight(i);
      double along = x * force.x() + y * force.y() + z * force.z();
      double push = (1 - minus / 2) * w * 3 * along;
      project(m.along, m.x, m.y, m.z, x, y, z, n);
      symmetricSource(m, w, plus, 9 * along * forced, 3 * forced, n);
      relaxPairQuadratic(f[i], f[i + 1], m, 3 * w, plus / 2, minus / 2, push, n);
    }
  }

  /** f -= omega+ (f - w (rho - 1)). */
  private static void relaxRest(double[] f, double[] density, double plus, double w, int n) {
    for (int k = 0; k < n; k++) {
      f[k] += plus * (w * density[k] - f[k]);
    }
  }

  /** along = x a + y b + z c. */
  private static void project(
      double[] along, double[] a, double[] b, double[] c, double x, double y, double z, int n) {
    for (int k = 0; k < n; k++) {
      along[k] = x * a[k] + y * b[k] + z * c[k];
    }
  }

  /** The linear pair: s_eq = w (rho - 1), a_eq = {@code odd}; the rates come halved. */
  private static void relaxPair(
      double[] f,
      double[] opposite,
      double[] density,
      double[] odd,
      double w,
      double halfPlus,
      double halfMinus,
      double push,
      int n) {
    for (int k = 0; k < n; k++) {
      double s = halfPlus * (2 * w * density[k] - (f[k] + opposite[k]));
      double a = halfMinus * (2 * odd[k] - (f[k] - opposite[k])) + push;
      f[k] += s + a;
      opposite[k] += s - a;
    }
  }

  /** squares = 3/2 u², work = u.F. */
  private void square(MomentRows m, int n) {
    double fx = force.x();
    double fy = force.y();
    double fz = force.z();
    for (int k = 0; k < n; k++) {
      m.squares[k] = 1.5 * (m.x[k] * m.x[k] + m.y[k] * m.y[k] + m.z[k] * m.z[k]);
    }
    for (int k = 0; k < n; k++) {
      m.work[k] = fx * m.x[k] + fy * m.y[k] + fz * m.z[k];
    }
  }

  private static void relaxRestQuadratic(
      double[] f, MomentRows m, double w, double plus, double forced, int n) {
    double[] density = m.density;
    double[] squares = m.squares;
    double[] work = m.work;
    for (int k = 0; k < n; k++) {
      double rest = w * (density[k] - (1 + density[k]) * squares[k]);
      f[k] += plus * (rest - f[k]) - forced * w * 3 * work[k];
    }
  }

  /** even = omega+ s_eq + the symmetric part of the force; the rates are worked in. */
  private static void symmetricSource(
      MomentRows m, double w, double plus, double alongForced, double workForced, int n) {
    double[] even = m.even;
    double[] density = m.density;
    double[] squares = m.squares;
    double[] along = m.along;
    double[] work = m.work;
    for (int k = 0; k < n; k++) {
      double cu = along[k];
      double equilibrium = density[k] + (1 + density[k]) * (4.5 * cu * cu - squares[k]);
      even[k] = w * (plus * equilibrium + alongForced * cu - workForced * work[k]);
    }
  }

  /** The quadratic pair: even already holds omega+ s_eq + force, a_eq = 3 w rho c.u. */
  private static void relaxPairQuadratic(
      double[] f,
      double[] opposite,
      MomentRows m,
      double tripleWeight,
      double halfPlus,
      double halfMinus,
      double push,
      int n) {
    double[] even = m.even;
    double[] density = m.density;
    double[] along = m.along;
    for (int k = 0; k < n; k++) {
      double odd = tripleWeight * (1 + density[k]) * along[k];
      double s = even[k] - halfPlus * (f[k] + opposite[k]);
      double a = halfMinus * (2 * odd - (f[k] - opposite[k])) + push;
      f[k] += s + a;
      opposite[k] += s - a;
    }
  }
}
