package org.hdispatch.lbm;

import java.util.Arrays;

/** Rows of moments of up to {@link StreamPlan#CHUNK} nodes: part of a worker's scratch. */
final class MomentRows {
  /** rho - 1. */
  final double[] density = new double[StreamPlan.CHUNK];

  /** Momentum or velocity. */
  final double[] x = new double[StreamPlan.CHUNK];

  final double[] y = new double[StreamPlan.CHUNK];
  final double[] z = new double[StreamPlan.CHUNK];

  /** Projection on the velocity of a pair. */
  final double[] along = new double[StreamPlan.CHUNK];

  /** 3/2 u². */
  final double[] squares = new double[StreamPlan.CHUNK];

  /** u.F. */
  final double[] work = new double[StreamPlan.CHUNK];

  /** Symmetric source of a pair. */
  final double[] even = new double[StreamPlan.CHUNK];

  /** Sums density and momentum of populations that lie less their weights. */
  void sum(VelocitySet set, double[][] f, int n) {
    System.arraycopy(f[0], 0, density, 0, n);
    clear(x, y, z, n);
    for (int i = 1; i < f.length; i += 2) {
      addPairs(density, f[i], f[i + 1], n);
      addMomentum(x, f[i], f[i + 1], set.cx(i), n);
      addMomentum(y, f[i], f[i + 1], set.cy(i), n);
      addMomentum(z, f[i], f[i + 1], set.cz(i), n);
    }
  }

  private static void clear(double[] a, double[] b, double[] c, int n) {
    Arrays.fill(a, 0, n, 0);
    Arrays.fill(b, 0, n, 0);
    Arrays.fill(c, 0, n, 0);
  }

  private static void addPairs(double[] sum, double[] f, double[] opposite, int n) {
    for (int k = 0; k < n; k++) {
      sum[k] += f[k] + opposite[k];
    }
  }

  private static void addMomentum(double[] sum, double[] f, double[] opposite, int c, int n) {
    if (c > 0) {
      for (int k = 0; k < n; k++) {
        sum[k] += f[k] - opposite[k];
      }
    } else if (c < 0) {
      for (int k = 0; k < n; k++) {
        sum[k] += opposite[k] - f[k];
      }
    }
  }

  void addToMomentum(double dx, double dy, double dz, int n) {
    for (int k = 0; k < n; k++) {
      x[k] += dx;
    }
    for (int k = 0; k < n; k++) {
      y[k] += dy;
    }
    for (int k = 0; k < n; k++) {
      z[k] += dz;
    }
  }

  /** u = j / rho. */
  void momentumToVelocity(int n) {
    for (int k = 0; k < n; k++) {
      double volume = 1 / (1 + density[k]);
      x[k] *= volume;
      y[k] *= volume;
      z[k] *= volume;
    }
  }
}
