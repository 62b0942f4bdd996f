package org.hdispatch.poisson;

import java.util.Arrays;

/**
 * The passes over the cells of a level. Each writes vectors of its own cell only, and reads of
 * other cells only vectors that it does not write; {@code sums} is the worker's scratch, a value
 * for each node.
 */
final class Kernels {
  private Kernels() {}

  /** Residual of the solution so far, at the finest level. Sums: |residual|², |right side|². */
  static void begin(GraphCell cell, double[] sums, Level level) {
    double[] solution = cell.solution;
    Arrays.fill(sums, 0, cell.nodes, 0);
    HaloLinks halo = cell.halo;
    int n = 0;
    for (int c = 0; c < halo.cells().length; c++) {
      double[] others = halo.cells()[c].solution;
      for (int end = halo.end()[c]; n < end; n++) {
        int m = halo.row()[n];
        sums[m] += halo.mobility()[n] * (solution[m] - others[halo.to()[n]]);
      }
    }
    addOutflow(cell, solution, sums);
    double residuals = 0;
    double sources = 0;
    for (int m = 0; m < cell.nodes; m++) {
      double source = level.clusters.balanced(cell, m) * level.sourceFactor;
      if (cell.fixedSource != null) {
        source += cell.fixedSource[m];
      }
      double residual = source - sums[m];
      cell.residual[m] = residual;
      residuals += residual * residual;
      sources += source * source;
    }
    cell.sums[0] = residuals;
    cell.sums[1] = sources;
  }

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

  /**
   * The next direction, preconditioned + beta times the previous one, and its product with the
   * matrix. Sums: direction . product, direction . residual, residual . product, |product|².
   */
  static void direct(GraphCell cell, double[] sums, double beta, int previous) {
    double[] preconditioned = cell.preconditioned;
    double[] before = cell.direction[previous];
    double[] current = cell.direction[1 - previous];
    for (int m = 0; m < current.length; m++) {
      current[m] = preconditioned[m] + beta * before[m];
    }
    Arrays.fill(sums, 0, cell.nodes, 0);
    HaloLinks halo = cell.halo;
    char[] row = halo.row();
    char[] haloTo = halo.to();
    double[] haloMobility = halo.mobility();
    int n = 0;
    for (int c = 0; c < halo.cells().length; c++) {
      double[] others = halo.cells()[c].preconditioned;
      double[] othersBefore = halo.cells()[c].direction[previous];
      for (int end = halo.end()[c]; n < end; n++) {
        int there = haloTo[n];
        double value = others[there] + beta * othersBefore[there];
        sums[row[n]] += haloMobility[n] * (current[row[n]] - value);
      }
    }
    addOutflow(cell, current, sums);
    double directionProduct = 0;
    double directionResidual = 0;
    double residualProduct = 0;
    double products = 0;
    double[] residual = cell.residual;
    double[] product = cell.product;
    for (int m = 0; m < product.length; m++) {
      double value = sums[m];
      product[m] = value;
      directionProduct += current[m] * value;
      directionResidual += current[m] * residual[m];
      residualProduct += residual[m] * value;
      products += value * value;
    }
    cell.sums[0] = directionProduct;
    cell.sums[1] = directionResidual;
    cell.sums[2] = residualProduct;
    cell.sums[3] = products;
  }

  /** Adds what flows out of each node, but for the links to other cells. */
  private static void addOutflow(GraphCell cell, double[] values, double[] sums) {
    if (cell.ground != null) {
      for (int m = 0; m < values.length; m++) {
        sums[m] += cell.ground[m] * values[m];
      }
    }
    int[] lowerStart = cell.lower.start();
    char[] lowerTo = cell.lower.to();
    double[] lowerMobility = cell.lower.mobility();
    int[] upperStart = cell.upper.start();
    char[] upperTo = cell.upper.to();
    double[] upperMobility = cell.upper.mobility();
    for (int m = 0; m < values.length; m++) {
      double here = values[m];
      double flux = sums[m];
      for (int t = lowerStart[m], end = lowerStart[m + 1]; t < end; t++) {
        flux += outflow(lowerMobility, lowerTo, values, here, 3 * t);
      }
      for (int t = upperStart[m], end = upperStart[m + 1]; t < end; t++) {
        flux += outflow(upperMobility, upperTo, values, here, 3 * t);
      }
      sums[m] = flux;
    }
  }

  private static double outflow(double[] mobility, char[] to, double[] values, double here, int n) {
    return mobility[n] * (here - values[to[n]])
        + mobility[n + 1] * (here - values[to[n + 1]])
        + mobility[n + 2] * (here - values[to[n + 2]]);
  }

  /** Goes along the direction, and no further. */
  static void finish(GraphCell cell, double alpha, int current) {
    double[] solution = cell.solution;
    double[] direction = cell.direction[current];
    for (int m = 0; m < solution.length; m++) {
      solution[m] += alpha * direction[m];
    }
  }
}
