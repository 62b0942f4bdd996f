package org.hdispatch.lbm;

/** {@link Collision}, node by node: the readable form, and the oracle of the fast ones. */
final class NodeKernel implements CollisionKernel {
  private final VelocitySet set;
  private final boolean quadratic;
  private final CollisionCoefficients c;
  private final double[] f;

  NodeKernel(CollisionCoefficients coefficients) {
    c = coefficients;
    set = c.set();
    quadratic = c.equilibrium() == Equilibrium.QUADRATIC;
    f = new double[set.size()];
  }

  @Override
  public void collide(
      double[][] in, int[] inAt, double[][] out, int[] outAt, int n, int rows, int pitch) {
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
    double jx = c.forceX() / 2;
    double jy = c.forceY() / 2;
    double jz = c.forceZ() / 2;
    for (int i = 1; i < f.length; i += 2) {
      double a = f[i] - f[i + 1];
      d += f[i] + f[i + 1];
      jx = set.cx(i) == 0 ? jx : Math.fma(set.cx(i), a, jx);
      jy = set.cy(i) == 0 ? jy : Math.fma(set.cy(i), a, jy);
      jz = set.cz(i) == 0 ? jz : Math.fma(set.cz(i), a, jz);
    }
    double v = 0;
    double base = d;
    if (quadratic) {
      v = 1 / (1 + d);
      double jj = Math.fma(jx, jx, Math.fma(jy, jy, jz * jz));
      double jf = Math.fma(c.forceX(), jx, Math.fma(c.forceY(), jy, c.forceZ() * jz));
      base = Math.fma(c.omegaPlus, d, v * Math.fma(c.squares, jj, c.work * jf));
    }
    f[0] = Math.fma(c.keepRest, f[0], c.even[0] * base);
    for (int p = 1; p < c.even.length; p++) {
      int i = 2 * p - 1;
      double forth = f[i];
      double back = f[i + 1];
      double cj = project(i, jx, jy, jz);
      double form = quadratic ? Math.fma(v * cj, Math.fma(c.curvature, cj, c.along[p]), base) : d;
      double even = c.even[p] * form;
      double odd = Math.fma(c.odd[p], cj, c.push[p]);
      f[i] = Math.fma(c.keep, forth, Math.fma(c.cross, back, even)) + odd;
      f[i + 1] = Math.fma(c.keep, back, Math.fma(c.cross, forth, even)) - odd;
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
        sum = first ? component * j : Math.fma(component, j, sum);
        first = false;
      }
    }
    return sum;
  }
}
