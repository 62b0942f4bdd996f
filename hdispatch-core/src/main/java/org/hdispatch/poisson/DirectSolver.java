package org.hdispatch.poisson;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.hdispatch.cell.CellMap;

/**
 * Solves the coarsest level by a Cholesky factor with an envelope: row i is stored from the first
 * node that i is linked to. A cluster without a fixed side leaves a pivot of rounding errors at its
 * last node; there the solution is 0.
 */
final class DirectSolver {
  /** Most nodes that are solved for directly. */
  static final int MOST_NODES = 400;

  /** A pivot below this share of the diagonal is none. */
  private static final double ROUNDING = 1e-9;

  private final CellMap<GraphCell> cells;
  private final double[][] factor; // row i: columns first(i) to i
  private final double[] values;

  DirectSolver(CellMap<GraphCell> cells) {
    this.cells = cells;
    Map<GraphCell, Integer> offsets = new HashMap<>();
    int nodes = 0;
    for (int n = 0; n < cells.size(); n++) {
      offsets.put(cells.cellAt(n), nodes);
      nodes += cells.cellAt(n).nodes;
    }
    values = new double[nodes];
    double[][] full = new double[nodes][];
    for (int n = 0; n < cells.size(); n++) {
      fill(cells.cellAt(n), offsets, full);
    }
    factor = full;
    factorise();
  }

  private static void fill(GraphCell cell, Map<GraphCell, Integer> offsets, double[][] rows) {
    int offset = offsets.get(cell);
    for (int m = 0; m < cell.nodes; m++) {
      double[] row = new double[offset + m + 1];
      Links links = cell.lower;
      for (int n = links.begin(m); n < links.end(m); n++) {
        row[offset + links.to()[n]] -= links.mobility()[n];
      }
      row[offset + m] = cell.inverseDiagonal[m] > 0 ? 1 / cell.inverseDiagonal[m] : 0;
      rows[offset + m] = row;
    }
    HaloLinks halo = cell.halo;
    GraphCell[] others = halo.cellOfEach();
    for (int n = 0; n < others.length; n++) {
      int column = offsets.get(others[n]) + halo.to()[n];
      if (column < offset) {
        rows[offset + halo.row()[n]][column] -= halo.mobility()[n];
      }
    }
    for (int m = offset; m < offset + cell.nodes; m++) {
      int first = 0;
      while (first < m && rows[m][first] == 0) {
        first++;
      }
      rows[m] = Arrays.copyOfRange(rows[m], first, m + 1);
    }
  }

  private void factorise() {
    for (int i = 0; i < factor.length; i++) {
      double[] row = factor[i];
      int first = first(i);
      for (int j = first; j < i; j++) {
        double sum = row[j - first];
        int from = Math.max(first, first(j));
        for (int k = from; k < j; k++) {
          sum -= row[k - first] * factor[j][k - first(j)];
        }
        double pivot = factor[j][j - first(j)];
        row[j - first] = pivot > 0 ? sum / pivot : 0;
      }
      double diagonal = row[i - first];
      double sum = diagonal;
      for (int k = first; k < i; k++) {
        sum -= row[k - first] * row[k - first];
      }
      row[i - first] = sum > ROUNDING * diagonal ? Math.sqrt(sum) : 0;
    }
  }

  private int first(int row) {
    return row + 1 - factor[row].length;
  }

  /** Solves for what stands in the residuals of the cells; the solution is in the values then. */
  private void solve() {
    int next = 0;
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      System.arraycopy(cell.residual, 0, values, next, cell.nodes);
      next += cell.nodes;
    }
    for (int i = 0; i < factor.length; i++) {
      double[] row = factor[i];
      int first = first(i);
      double sum = values[i];
      for (int k = first; k < i; k++) {
        sum -= row[k - first] * values[k];
      }
      double pivot = row[i - first];
      values[i] = pivot > 0 ? sum / pivot : 0;
    }
    for (int i = factor.length - 1; i >= 0; i--) {
      double[] row = factor[i];
      int first = first(i);
      double pivot = row[i - first];
      double value = pivot > 0 ? values[i] / pivot : 0;
      values[i] = value;
      for (int k = first; k < i; k++) {
        values[k] -= row[k - first] * value;
      }
    }
  }

  /** From the residuals of the cells to their solutions. */
  void solveForSolution() {
    solve();
    int next = 0;
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      System.arraycopy(values, next, cell.solution, 0, cell.nodes);
      next += cell.nodes;
    }
  }

  /** From the residuals of the cells to preconditioned ones. */
  void precondition() {
    solve();
    int next = 0;
    for (int n = 0; n < cells.size(); n++) {
      GraphCell cell = cells.cellAt(n);
      double products = 0;
      for (int m = 0; m < cell.nodes; m++) {
        double value = values[next++];
        cell.preconditioned[m] = value;
        products += value * cell.product[m];
      }
      cell.sums[0] = products;
    }
  }
}
