package org.hdispatch.poisson;

/** What goes between the cells of the finest level and functions of the coordinates of a node. */
final class Fields {
  private Fields() {}

  /** Adds a field to the sources of a cell. */
  static void addSources(GraphCell cell, NodeField field) {
    int[] at = new int[3];
    for (int m = 0; m < cell.nodes; m++) {
      cell.source[m] += value(field, cell, m, at, "source must be finite", "source");
    }
  }

  /** Makes a field the solution of a cell. */
  static void guess(GraphCell cell, NodeField field) {
    int[] at = new int[3];
    for (int m = 0; m < cell.nodes; m++) {
      cell.solution[m] = value(field, cell, m, at, "first guess must be finite", "p");
    }
  }

  /** Sums a field over a cell. Sums: that. */
  static void sum(GraphCell cell, NodeField field) {
    int[] at = new int[3];
    double sum = 0;
    for (int m = 0; m < cell.nodes; m++) {
      sum += value(field, cell, m, at, "field must be finite", "value");
    }
    cell.sums[0] = sum;
  }

  /** Shows the solution of a cell. */
  static void show(GraphCell cell, NodeVisitor visitor) {
    int[] at = new int[3];
    for (int m = 0; m < cell.nodes; m++) {
      FineCells.coordinates(cell, m, at);
      visitor.visit(at[0], at[1], at[2], cell.solution[m]);
    }
  }

  private static double value(
      NodeField field, GraphCell cell, int node, int[] at, String rule, String name) {
    FineCells.coordinates(cell, node, at);
    double value = field.at(at[0], at[1], at[2]);
    if (!Double.isFinite(value)) {
      throw Refusal.value(rule, name, value, at[0], at[1], at[2]);
    }
    return value;
  }
}
