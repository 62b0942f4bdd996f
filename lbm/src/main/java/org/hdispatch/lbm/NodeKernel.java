package org.hdispatch.lbm;

/**
 * {@link Collision}, node by node: the readable form, and the oracle of the fast ones.
 *
 * <p>In single precision each operation is rounded on its own. Sums, products and quotients of
 * single-precision numbers computed in double and then rounded are what single precision gives.
 */
final class NodeKernel implements CollisionKernel {
  private final VelocitySet set;
  private final boolean quadratic;
  private final CollisionCoefficients c;
  private final double[] f;
  private boolean single; // precision of the node in work

  NodeKernel(CollisionCoefficients coefficients) {
    c = coefficients;
    set = c.set();
    quadratic = c.equilibrium() == Equilibrium.QUADRATIC;
    f = new double[set.size()];
  }

  @Override
  public void collide(
      double[][] in, int[] inAt, double[][] out, int[] outAt, int n, int rows, int pitch) {
    single = false;
    for (int row = 0; row < rows; row++) {
      for (int k = row * pitch; k < row * pitch + n; k++) {
        for (int i = 0; i < f.length; i++) {
          f[i] = in[i][inAt[i] + k];
        }
        collide();
        for (int i = 0; i < f.length; i++) {
          out[i][outAt[i] + k] = f[set.opposite(i)];
        }
      }
    }
  }

  @Override
  public void collide(
      float[][] in, int[] inAt, float[][] out, int[] outAt, int n, int rows, int pitch) {
    single = true;
    for (int row = 0; row < rows; row++) {
      for (int k = row * pitch; k < row * pitch + n; k++) {
        for (int i = 0; i < f.length; i++) {
          f[i] = in[i][inAt[i] + k];
        }
        collide();
        for (int i = 0; i < f.length; i++) {
          out[i][outAt[i] + k] = (float) f[set.opposite(i)];
        }
      }
    }
  }

  private void collide() {
    double d = f[0];
    double jx = round(c.forceX() / 2);
    double jy = round(c.forceY() / 2);
    double jz = round(c.forceZ() / 2);
    for (int i = 1; i < f.length; i += 2) {
      double a = round(f[i] - f[i + 1]);
      d = round(d + round(f[i] + f[i + 1]));
      jx = set.cx(i) == 0 ? jx : fma(set.cx(i), a, jx);
      jy = set.cy(i) == 0 ? jy : fma(set.cy(i), a, jy);
      jz = set.cz(i) == 0 ? jz : fma(set.cz(i), a, jz);
    }
    double v = 0;
    double base = d;
    if (quadratic) {
      v = round(1 / round(1 + d));
      double jj = fma(jx, jx, fma(jy, jy, round(jz * jz)));
      double jf = fma(c.forceX(), jx, fma(c.forceY(), jy, times(c.forceZ(), jz)));
      base = fma(c.omegaPlus, d, times(v, fma(c.squares, jj, times(c.work, jf))));
    }
    f[0] = fma(c.keepRest, f[0], times(c.even[0], base));
    for (int p = 1; p < c.even.length; p++) {
      int i = 2 * p - 1;
      double forth = f[i];
      double back = f[i + 1];
      double cj = project(i, jx, jy, jz);
      double form = quadratic ? fma(times(v, cj), fma(c.curvature, cj, c.along[p]), base) : d;
      double even = times(c.even[p], form);
      double odd = fma(c.odd[p], cj, c.push[p]);
      f[i] = round(fma(c.keep, forth, fma(c.cross, back, even)) + odd);
      f[i + 1] = round(fma(c.keep, back, fma(c.cross, forth, even)) - odd);
    }
  }

  /** c_i . j, over the components of c_i that are not 0, in order. */
  private double project(int i, double jx, double jy, double jz) {
    double sum = 0;
    boolean first = true;
    for (int axis = 0; axis < 3; axis++) {
      int component = set.component(i, axis);
      double j = axis == 0 ? jx : axis == 1 ? jy : jz;
      if (component != 0) {
        sum = first ? component * j : fma(component, j, sum);
        first = false;
      }
    }
    return sum;
  }

  private double times(double a, double b) {
    return round(round(a) * round(b));
  }

  /** a b + c, rounded once. */
  private double fma(double a, double b, double c) {
    return single ? Math.fma((float) a, (float) b, (float) c) : Math.fma(a, b, c);
  }

  private double round(double a) {
    return single ? (float) a : a;
  }
}
