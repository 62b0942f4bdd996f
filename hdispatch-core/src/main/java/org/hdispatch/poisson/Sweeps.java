package org.hdispatch.poisson;

import java.util.Arrays;

/**
 * The passes of the preconditioner over the cells of a level; the rules and the scratch are those
 * of {@link Kernels}.
 */
final class Sweeps {
  private Sweeps() {}

  /** Takes the restricted residual from the next finer level. Sums: |residual|². */
  static void collect(GraphCell cell) {
    int n = 0;
    double residuals = 0;
    for (GraphCell child : cell.children) {
      for (double value : child.restricted) {
        cell.residual[n] = value;
        cell.solution[n++] = 0;
        residuals += value * value;
      }
    }
    cell.sums[0] = residuals;
  }

  /**
   * Goes along the direction, then sweeps forward from zero: Gauss-Seidel over the cell's own
   * nodes. Sums: |residual|².
   */
  static void forward(GraphCell cell, double alpha, int current) {
    double[] residual = cell.residual;
    double[] solution = cell.solution;
    double[] smoothed = cell.smoothed;
    double[] product = cell.product;
    double[] direction = cell.direction[current];
    double[] inverseDiagonal = cell.inverseDiagonal;
    int[] start = cell.lower.start();
    char[] to = cell.lower.to();
    double[] mobility = cell.lower.mobility();
    double residuals = 0;
    for (int m = 0; m < residual.length; m++) {
      double r = residual[m] - alpha * product[m];
      residual[m] = r;
      solution[m] += alpha * direction[m];
      residuals += r * r;
      double sum = r;
      for (int t = start[m], end = start[m + 1]; t < end; t++) {
        sum += threeTimes(mobility, to, smoothed, 3 * t);
      }
      smoothed[m] = sum * inverseDiagonal[m];
    }
    cell.sums[0] = residuals;
  }

  private static double threeTimes(double[] mobility, char[] to, double[] values, int n) {
    return mobility[n] * values[to[n]]
        + mobility[n + 1] * values[to[n + 1]]
        + mobility[n + 2] * values[to[n + 2]];
  }

  /**
   * Adds up what the forward sweep left over, by aggregates: the links to nodes it came to later.
   */
  static void restrict(GraphCell cell) {
    double[] restricted = cell.restricted;
    Arrays.fill(restricted, 0);
    char[] aggregate = cell.aggregate;
    HaloLinks halo = cell.halo;
    char[] row = halo.row();
    char[] haloTo = halo.to();
    double[] haloMobility = halo.mobility();
    int n = 0;
    for (int c = 0; c < halo.cells().length; c++) {
      double[] others = halo.cells()[c].smoothed;
      for (int end = halo.end()[c]; n < end; n++) {
        restricted[aggregate[row[n]]] += haloMobility[n] * others[haloTo[n]];
      }
    }
    double[] smoothed = cell.smoothed;
    int[] start = cell.upper.start();
    char[] to = cell.upper.to();
    double[] mobility = cell.upper.mobility();
    for (int m = 0; m < smoothed.length; m++) {
      double sum = 0;
      for (int t = start[m], end = start[m + 1]; t < end; t++) {
        sum += threeTimes(mobility, to, smoothed, 3 * t);
      }
      int a = aggregate[m];
      if (a != GraphCell.NONE) {
        restricted[a] += sum;
      }
    }
  }

  /** Adds the coarse solution, then sweeps backward. Sums: preconditioned . product. */
  static void backward(GraphCell cell, double[] sums) {
    double[] values = cell.preconditioned;
    double[] residual = cell.residual;
    System.arraycopy(residual, 0, sums, 0, cell.nodes);
    HaloLinks halo = cell.halo;
    char[] row = halo.row();
    char[] haloTo = halo.to();
    double[] haloMobility = halo.mobility();
    int n = 0;
    for (int c = 0; c < halo.cells().length; c++) {
      GraphCell other = halo.cells()[c];
      double[] others = other.smoothed;
      double[] coarse = other.parent == null ? null : other.parent.solution;
      int offset = other.parentOffset;
      char[] aggregate = other.aggregate;
      for (int end = halo.end()[c]; n < end; n++) {
        int m = haloTo[n];
        double value = others[m];
        if (coarse != null) { // who has a link to another cell has an aggregate
          value += coarse[offset + aggregate[m]];
        }
        sums[row[n]] += haloMobility[n] * value;
      }
    }
    correct(cell);
    double[] product = cell.product;
    double[] inverseDiagonal = cell.inverseDiagonal;
    int[] lowerStart = cell.lower.start();
    char[] lowerTo = cell.lower.to();
    double[] lowerMobility = cell.lower.mobility();
    int[] upperStart = cell.upper.start();
    char[] upperTo = cell.upper.to();
    double[] upperMobility = cell.upper.mobility();
    double products = 0;
    for (int m = values.length - 1; m >= 0; m--) {
      double sum = sums[m];
      for (int t = lowerStart[m], end = lowerStart[m + 1]; t < end; t++) {
        sum += threeTimes(lowerMobility, lowerTo, values, 3 * t);
      }
      for (int t = upperStart[m], end = upperStart[m + 1]; t < end; t++) {
        sum += threeTimes(upperMobility, upperTo, values, 3 * t);
      }
      double value = sum * inverseDiagonal[m];
      values[m] = value;
      products += value * product[m];
    }
    cell.sums[0] = products;
  }

  private static void correct(GraphCell cell) {
    double[] smoothed = cell.smoothed;
    double[] values = cell.preconditioned;
    if (cell.parent == null) {
      System.arraycopy(smoothed, 0, values, 0, values.length);
      return;
    }
    double[] coarse = cell.parent.solution;
    int offset = cell.parentOffset;
    char[] aggregate = cell.aggregate;
    for (int m = 0; m < values.length; m++) {
      int a = aggregate[m];
      values[m] = a == GraphCell.NONE ? smoothed[m] : smoothed[m] + coarse[offset + a];
    }
  }
}
