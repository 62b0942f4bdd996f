package org.hdispatch.lbm;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * {@link Collision} as a list of small loops over rows of nodes, made from the lattice's table.
 *
 * <p>Nodes are worked on in chunks, copied into rows of the kernel's own that stay in the L1 cache.
 * Each operation is a loop over at most five rows, short enough for C2 to unroll it and to turn it
 * into vector instructions; the obvious loop over all populations at once is not. The operations
 * are called through one interface with many implementations, so that they are never inlined into
 * one another: inlined, JDK 17 often leaves them scalar.
 */
final class LoopKernel implements CollisionKernel {
  private final int velocities;
  private final double[][] rows; // populations, then the rows below
  private final int density;
  private final int momentum; // three rows
  private final int volume;
  private final int base;
  private final int along;
  private final CollisionCoefficients coefficients;
  private final RowOperation[] operations;

  LoopKernel(CollisionCoefficients coefficients) {
    this.coefficients = coefficients;
    VelocitySet set = coefficients.set();
    velocities = set.size();
    density = velocities;
    momentum = velocities + 1;
    volume = velocities + 4;
    base = velocities + 5;
    along = velocities + 6;
    rows = new double[velocities + 7][Chunk.PADDED];
    operations = operations(set, coefficients).toArray(RowOperation[]::new);
  }

  private List<RowOperation> operations(VelocitySet set, CollisionCoefficients c) {
    boolean quadratic = c.equilibrium() == Equilibrium.QUADRATIC;
    List<RowOperation> list = new ArrayList<>();
    for (int i = 1; i < velocities; i += 2) {
      list.add(moments(set, i));
    }
    if (quadratic) {
      list.add(new Volume(density, volume));
      list.add(new Squares(momentum, c, base));
      list.add(new Base(density, volume, c.omegaPlus, base));
    }
    list.add(new Rest(quadratic ? base : density, c.keepRest, c.even[0]));
    for (int i = 1; i < velocities; i += 2) {
      int p = (i + 1) / 2;
      int projected = projectedRow(set, i);
      if (projected == along) {
        list.add(project(set, i));
      }
      list.add(
          quadratic
              ? new QuadraticPair(p, projected, volume, base, c)
              : new LinearPair(p, projected, density, c));
    }
    return list;
  }

  /** Row of c_i . j: one of the momentum where c_i points along an axis. */
  private int projectedRow(VelocitySet set, int i) {
    boolean positiveAxis = set.axes(i).length == 1 && set.component(i, set.axes(i)[0]) > 0;
    return positiveAxis ? momentum + set.axes(i)[0] : along;
  }

  private RowOperation moments(VelocitySet set, int i) {
    int[] axes = set.axes(i);
    double a = set.component(i, axes[0]);
    if (axes.length == 1) {
      return new Moments1(i, density, momentum + axes[0], a);
    }
    double b = set.component(i, axes[1]);
    if (axes.length == 2) {
      return new Moments2(i, density, momentum + axes[0], momentum + axes[1], a, b);
    }
    return new Moments3(i, density, momentum, a, b, set.component(i, axes[2]));
  }

  private RowOperation project(VelocitySet set, int i) {
    int[] axes = set.axes(i);
    double a = set.component(i, axes[0]);
    if (axes.length == 1) {
      return new Project1(momentum + axes[0], a, along);
    }
    double b = set.component(i, axes[1]);
    if (axes.length == 2) {
      return new Project2(momentum + axes[0], momentum + axes[1], a, b, along);
    }
    return new Project3(momentum, a, b, set.component(i, axes[2]), along);
  }

  @Override
  public void collide(
      double[][] in, int[] inAt, double[][] out, int[] outAt, int n, int rowCount, int pitch) {
    int nodes = n * rowCount;
    for (int first = 0; first < nodes; first += Chunk.NODES) {
      int count = Math.min(Chunk.NODES, nodes - first);
      for (int i = 0; i < velocities; i++) {
        for (int k = 0; k < count; k += piece(first + k, n, count - k)) {
          int at = inAt[i] + place(first + k, n, pitch);
          System.arraycopy(in[i], at, rows[i], k, piece(first + k, n, count - k));
        }
      }
      collide(count);
      for (int i = 0; i < velocities; i++) {
        for (int k = 0; k < count; k += piece(first + k, n, count - k)) {
          int at = outAt[i] + place(first + k, n, pitch);
          System.arraycopy(rows[i], k, out[i], at, piece(first + k, n, count - k));
        }
      }
    }
  }

  @Override
  public void collide(
      float[][] in, int[] inAt, float[][] out, int[] outAt, int n, int rowCount, int pitch) {
    int nodes = n * rowCount;
    for (int first = 0; first < nodes; first += Chunk.NODES) {
      int count = Math.min(Chunk.NODES, nodes - first);
      for (int i = 0; i < velocities; i++) {
        for (int k = 0; k < count; k += piece(first + k, n, count - k)) {
          int at = inAt[i] + place(first + k, n, pitch);
          Chunk.widen(in[i], at, rows[i], k, piece(first + k, n, count - k));
        }
      }
      collide(count);
      for (int i = 0; i < velocities; i++) {
        for (int k = 0; k < count; k += piece(first + k, n, count - k)) {
          int at = outAt[i] + place(first + k, n, pitch);
          Chunk.narrow(rows[i], k, out[i], at, piece(first + k, n, count - k));
        }
      }
    }
  }

  /** Where a node lies, counted through all rows of n. */
  private static int place(int node, int n, int pitch) {
    return node / n * pitch + node % n;
  }

  /** Nodes from one to the end of its row, at most so many. */
  private static int piece(int node, int n, int most) {
    return Math.min(n - node % n, most);
  }

  private void collide(int n) {
    System.arraycopy(rows[0], 0, rows[density], 0, n);
    Arrays.fill(rows[momentum], 0, n, coefficients.forceX() / 2);
    Arrays.fill(rows[momentum + 1], 0, n, coefficients.forceY() / 2);
    Arrays.fill(rows[momentum + 2], 0, n, coefficients.forceZ() / 2);
    for (RowOperation operation : operations) {
      operation.apply(rows, n);
    }
  }

  /** A loop over nodes. */
  private interface RowOperation {
    void apply(double[][] rows, int n);
  }

  /** d += f + f', j += c (f - f'), c along one axis. */
  private record Moments1(int i, int density, int x, double cx) implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] f = rows[i];
      double[] g = rows[i + 1];
      double[] d = rows[density];
      double[] jx = rows[x];
      double a = cx;
      for (int k = 0; k < n; k++) {
        d[k] += f[k] + g[k];
        jx[k] = Math.fma(a, f[k] - g[k], jx[k]);
      }
    }
  }

  /** d += f + f', j += c (f - f'), c with two components. */
  private record Moments2(int i, int density, int x, int y, double cx, double cy)
      implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] f = rows[i];
      double[] g = rows[i + 1];
      double[] d = rows[density];
      double[] jx = rows[x];
      double[] jy = rows[y];
      double a = cx;
      double b = cy;
      for (int k = 0; k < n; k++) {
        d[k] += f[k] + g[k];
        jx[k] = Math.fma(a, f[k] - g[k], jx[k]);
        jy[k] = Math.fma(b, f[k] - g[k], jy[k]);
      }
    }
  }

  /** d += f + f', j += c (f - f'), c with three components. */
  private record Moments3(int i, int density, int momentum, double cx, double cy, double cz)
      implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] f = rows[i];
      double[] g = rows[i + 1];
      double[] d = rows[density];
      double[] jx = rows[momentum];
      double[] jy = rows[momentum + 1];
      double[] jz = rows[momentum + 2];
      double a = cx;
      double b = cy;
      double c = cz;
      for (int k = 0; k < n; k++) {
        d[k] += f[k] + g[k];
        jx[k] = Math.fma(a, f[k] - g[k], jx[k]);
        jy[k] = Math.fma(b, f[k] - g[k], jy[k]);
        jz[k] = Math.fma(c, f[k] - g[k], jz[k]);
      }
    }
  }

  /** v = 1/(1 + d). */
  private record Volume(int density, int volume) implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] d = rows[density];
      double[] v = rows[volume];
      for (int k = 0; k < n; k++) {
        v[k] = 1 / (1 + d[k]);
      }
    }
  }

  /** squares j.j + work j.F. */
  private record Squares(int momentum, CollisionCoefficients c, int to) implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] jx = rows[momentum];
      double[] jy = rows[momentum + 1];
      double[] jz = rows[momentum + 2];
      double[] row = rows[to];
      double fx = c.forceX();
      double fy = c.forceY();
      double fz = c.forceZ();
      double squares = c.squares;
      double work = c.work;
      for (int k = 0; k < n; k++) {
        double jj = Math.fma(jx[k], jx[k], Math.fma(jy[k], jy[k], jz[k] * jz[k]));
        double jf = Math.fma(fx, jx[k], Math.fma(fy, jy[k], fz * jz[k]));
        row[k] = Math.fma(squares, jj, work * jf);
      }
    }
  }

  /** base = omega+ d + v base. */
  private record Base(int density, int volume, double omegaPlus, int base) implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] d = rows[density];
      double[] v = rows[volume];
      double[] row = rows[base];
      double plus = omegaPlus;
      for (int k = 0; k < n; k++) {
        row[k] = Math.fma(plus, d[k], v[k] * row[k]);
      }
    }
  }

  /** The population at rest. */
  private record Rest(int form, double keep, double even) implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] f = rows[0];
      double[] row = rows[form];
      double own = keep;
      double e = even;
      for (int k = 0; k < n; k++) {
        f[k] = Math.fma(own, f[k], e * row[k]);
      }
    }
  }

  /** c.j with one component. */
  private record Project1(int x, double cx, int to) implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] jx = rows[x];
      double[] row = rows[to];
      double a = cx;
      for (int k = 0; k < n; k++) {
        row[k] = a * jx[k];
      }
    }
  }

  /** c.j with two components. */
  private record Project2(int x, int y, double cx, double cy, int to) implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] jx = rows[x];
      double[] jy = rows[y];
      double[] row = rows[to];
      double a = cx;
      double b = cy;
      for (int k = 0; k < n; k++) {
        row[k] = Math.fma(b, jy[k], a * jx[k]);
      }
    }
  }

  /** c.j with three components. */
  private record Project3(int momentum, double cx, double cy, double cz, int to)
      implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] jx = rows[momentum];
      double[] jy = rows[momentum + 1];
      double[] jz = rows[momentum + 2];
      double[] row = rows[to];
      double a = cx;
      double b = cy;
      double c = cz;
      for (int k = 0; k < n; k++) {
        row[k] = Math.fma(c, jz[k], Math.fma(b, jy[k], a * jx[k]));
      }
    }
  }

  /** Relaxes a pair towards the quadratic equilibrium and turns it round. */
  private record QuadraticPair(
      int pair, int projected, int volume, int base, CollisionCoefficients c)
      implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] f = rows[2 * pair - 1];
      double[] g = rows[2 * pair];
      double[] cj = rows[projected];
      double[] v = rows[volume];
      double[] b = rows[base];
      double own = c.keep;
      double other = c.cross;
      double e = c.even[pair];
      double o = c.odd[pair];
      double p = c.push[pair];
      double q = c.curvature;
      double l = c.along[pair];
      for (int k = 0; k < n; k++) {
        double forth = f[k];
        double back = g[k];
        double rise = e * Math.fma(v[k] * cj[k], Math.fma(q, cj[k], l), b[k]);
        double drift = Math.fma(o, cj[k], p);
        f[k] = Math.fma(own, back, Math.fma(other, forth, rise)) - drift;
        g[k] = Math.fma(own, forth, Math.fma(other, back, rise)) + drift;
      }
    }
  }

  /** Relaxes a pair towards the linear equilibrium and turns it round. */
  private record LinearPair(int pair, int projected, int density, CollisionCoefficients c)
      implements RowOperation {
    @Override
    public void apply(double[][] rows, int n) {
      double[] f = rows[2 * pair - 1];
      double[] g = rows[2 * pair];
      double[] cj = rows[projected];
      double[] d = rows[density];
      double own = c.keep;
      double other = c.cross;
      double e = c.even[pair];
      double o = c.odd[pair];
      double p = c.push[pair];
      for (int k = 0; k < n; k++) {
        double forth = f[k];
        double back = g[k];
        double rise = e * d[k];
        double drift = Math.fma(o, cj[k], p);
        f[k] = Math.fma(own, back, Math.fma(other, forth, rise)) - drift;
        g[k] = Math.fma(own, forth, Math.fma(other, back, rise)) + drift;
      }
    }
  }
}
