package org.hdispatch.poisson;

/**
 * The passes over the cells of a level. Each writes vectors of its own cell only, and reads of
 * other cells only vectors that it does not write; {@code u} is the worker's scratch: values at the
 * cell's own nodes and, after them, its halo.
 */
final class Kernels {
  private Kernels() {}

  /** Residual of the solution so far, at the finest level. Sums: |residual|², |right side|². */
  static void begin(GraphCell cell, double[] u, Level level) {
    System.arraycopy(cell.solution, 0, u, 0, cell.nodes);
    int h = 0;
    for (int c = 0; c < cell.haloCells.length; c++) {
      double[] from = cell.haloCells[c].solution;
      for (; h < cell.haloEnd[c]; h++) {
        u[cell.nodes + h] = from[cell.haloNodes[h]];
      }
    }
    double residuals = 0;
    double sources = 0;
    for (int m = 0; m < cell.nodes; m++) {
      double source = level.clusters.balanced(cell, m) * level.sourceFactor;
      if (cell.fixedSource != null) {
        source += cell.fixedSource[m];
      }
      double residual = source - flux(cell, u, m);
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
    int n = 0;
    for (int m = 0; m < cell.nodes; m++) {
      double r = residual[m] - alpha * product[m];
      residual[m] = r;
      solution[m] += alpha * direction[m];
      residuals += r * r;
      double sum = r;
      for (int end = start[m + 1]; n < end; n++) {
        sum += mobility[n] * smoothed[to[n]];
      }
      smoothed[m] = sum * inverseDiagonal[m];
    }
    cell.sums[0] = residuals;
  }

  /** Adds up what the forward sweep left over, by aggregates: the links to nodes behind. */
  static void restrict(GraphCell cell, double[] u) {
    System.arraycopy(cell.smoothed, 0, u, 0, cell.nodes);
    int h = 0;
    for (int c = 0; c < cell.haloCells.length; c++) {
      double[] from = cell.haloCells[c].smoothed;
      for (; h < cell.haloEnd[c]; h++) {
        u[cell.nodes + h] = from[cell.haloNodes[h]];
      }
    }
    double[] restricted = cell.restricted;
    for (int a = 0; a < restricted.length; a++) {
      restricted[a] = 0;
    }
    int[] start = cell.upper.start();
    char[] to = cell.upper.to();
    double[] mobility = cell.upper.mobility();
    char[] aggregate = cell.aggregate;
    int n = 0;
    for (int m = 0; m < cell.nodes; m++) {
      double sum = 0;
      for (int end = start[m + 1]; n < end; n++) {
        sum += mobility[n] * u[to[n]];
      }
      if (aggregate[m] != GraphCell.NONE) {
        restricted[aggregate[m]] += sum;
      }
    }
  }

  /** Adds the coarse solution, then sweeps backward. Sums: preconditioned . product. */
  static void backward(GraphCell cell, double[] u) {
    double[] own = cell.smoothed;
    for (int m = 0; m < cell.nodes; m++) {
      u[m] = own[m] + correction(cell, m);
    }
    int h = 0;
    for (int c = 0; c < cell.haloCells.length; c++) {
      GraphCell other = cell.haloCells[c];
      for (; h < cell.haloEnd[c]; h++) {
        int m = cell.haloNodes[h];
        u[cell.nodes + h] = other.smoothed[m] + correction(other, m);
      }
    }
    double[] residual = cell.residual;
    double[] preconditioned = cell.preconditioned;
    double[] product = cell.product;
    double[] inverseDiagonal = cell.inverseDiagonal;
    int[] lowerStart = cell.lower.start();
    char[] lowerTo = cell.lower.to();
    double[] lowerMobility = cell.lower.mobility();
    int[] upperStart = cell.upper.start();
    char[] upperTo = cell.upper.to();
    double[] upperMobility = cell.upper.mobility();
    double products = 0;
    for (int m = cell.nodes - 1; m >= 0; m--) {
      double sum = residual[m];
      for (int n = lowerStart[m]; n < lowerStart[m + 1]; n++) {
        sum += lowerMobility[n] * u[lowerTo[n]];
      }
      for (int n = upperStart[m]; n < upperStart[m + 1]; n++) {
        sum += upperMobility[n] * u[upperTo[n]];
      }
      double value = sum * inverseDiagonal[m];
      u[m] = value;
      preconditioned[m] = value;
      products += value * product[m];
    }
    cell.sums[0] = products;
  }

  private static double correction(GraphCell cell, int node) {
    if (cell.parent == null || cell.aggregate[node] == GraphCell.NONE) {
      return 0;
    }
    return cell.parent.solution[cell.parentOffset + cell.aggregate[node]];
  }

  /**
   * The next direction, preconditioned + beta times the previous one, and its product with the
   * matrix. Sums: direction . product, direction . residual, residual . product, |product|².
   */
  static void direct(GraphCell cell, double[] u, double beta, int previous) {
    double[] preconditioned = cell.preconditioned;
    double[] before = cell.direction[previous];
    double[] current = cell.direction[1 - previous];
    for (int m = 0; m < cell.nodes; m++) {
      double value = preconditioned[m] + beta * before[m];
      u[m] = value;
      current[m] = value;
    }
    int h = 0;
    for (int c = 0; c < cell.haloCells.length; c++) {
      double[] otherNew = cell.haloCells[c].preconditioned;
      double[] otherBefore = cell.haloCells[c].direction[previous];
      for (; h < cell.haloEnd[c]; h++) {
        int m = cell.haloNodes[h];
        u[cell.nodes + h] = otherNew[m] + beta * otherBefore[m];
      }
    }
    double directionProduct = 0;
    double directionResidual = 0;
    double residualProduct = 0;
    double products = 0;
    double[] residual = cell.residual;
    double[] product = cell.product;
    for (int m = 0; m < cell.nodes; m++) {
      double value = flux(cell, u, m);
      product[m] = value;
      directionProduct += u[m] * value;
      directionResidual += u[m] * residual[m];
      residualProduct += residual[m] * value;
      products += value * value;
    }
    cell.sums[0] = directionProduct;
    cell.sums[1] = directionResidual;
    cell.sums[2] = residualProduct;
    cell.sums[3] = products;
  }

  /** What flows out of a node: the row of the matrix times u. */
  private static double flux(GraphCell cell, double[] u, int m) {
    double here = u[m];
    double flux = cell.ground == null ? 0 : cell.ground[m] * here;
    Links lower = cell.lower;
    for (int n = lower.start()[m]; n < lower.start()[m + 1]; n++) {
      flux += lower.mobility()[n] * (here - u[lower.to()[n]]);
    }
    Links upper = cell.upper;
    for (int n = upper.start()[m]; n < upper.start()[m + 1]; n++) {
      flux += upper.mobility()[n] * (here - u[upper.to()[n]]);
    }
    return flux;
  }

  /** Goes along the direction, and no further. */
  static void finish(GraphCell cell, double alpha, int current) {
    double[] direction = cell.direction[current];
    for (int m = 0; m < cell.nodes; m++) {
      cell.solution[m] += alpha * direction[m];
    }
  }
}
