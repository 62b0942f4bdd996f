package org.hdispatch.poisson;

import java.util.Arrays;

/**
 * The passes of conjugate gradients over the cells of a level. Each writes vectors of its own cell
 * only, and reads of other cells only vectors that it does not write; {@code sums} is the worker's
 * scratch, a value for each node.
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
