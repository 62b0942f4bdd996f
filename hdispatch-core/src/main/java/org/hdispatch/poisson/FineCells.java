package org.hdispatch.poisson;

import java.util.Arrays;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;

/**
 * Cuts the active nodes of a problem into cells of {@link #EDGE}³ nodes, and links them. Boxes
 * without active nodes get no cell.
 */
final class FineCells {
  /** Nodes along an edge of a cell: vectors and links of a cell fit into the cache of a core. */
  static final int EDGE = 16;

  private static final int BOX = EDGE * EDGE * EDGE;

  private final PoissonProblem problem;
  private final double[] mobilities = new double[BOX]; // of the box last looked at
  private final char[] found = new char[BOX];
  private final CellLinker linker = new CellLinker();
  private CellMap<GraphCell> cells;

  private FineCells(PoissonProblem problem) {
    this.problem = problem;
  }

  static CellMap<GraphCell> of(PoissonProblem problem) {
    return new FineCells(problem).build();
  }

  private CellMap<GraphCell> build() {
    int[] boxes = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      boxes[axis] = (problem.extent(axis) + EDGE - 1) / EDGE;
    }
    CellGrid grid = CellGrid.of(boxes[0], boxes[1], boxes[2], Ends.OPEN);
    long[] keys = Arrays.stream(grid.keys()).filter(key -> look(key) > 0).toArray();
    cells = CellMap.fixed(keys, KeyOrder.MORTON, this::cell);
    for (int n = 0; n < cells.size(); n++) {
      link(cells.cellAt(n));
    }
    return cells;
  }

  /** Finds the active nodes of a box, in increasing position, and counts them. */
  private int look(long key) {
    int x0 = CellKey.i(key) * EDGE;
    int y0 = CellKey.j(key) * EDGE;
    int z0 = CellKey.k(key) * EDGE;
    int nodes = 0;
    for (int z = 0; z < Math.min(EDGE, problem.extent(2) - z0); z++) {
      for (int y = 0; y < Math.min(EDGE, problem.extent(1) - y0); y++) {
        for (int x = 0; x < Math.min(EDGE, problem.extent(0) - x0); x++) {
          double mobility = problem.mobility(x0 + x, y0 + y, z0 + z);
          if (mobility > 0) {
            int position = x + EDGE * (y + EDGE * z);
            mobilities[position] = mobility;
            found[nodes++] = (char) position;
          }
        }
      }
    }
    return nodes;
  }

  private GraphCell cell(long key) {
    GraphCell cell = new GraphCell(key, Arrays.copyOf(found, look(key)));
    cell.source = new double[cell.nodes];
    return cell;
  }

  private void link(GraphCell cell) {
    look(cell.key);
    linker.begin(cell);
    int[] at = new int[3];
    for (int node = 0; node < cell.nodes; node++) {
      double own = mobilities[cell.position[node]];
      for (Side side : Side.values()) {
        coordinates(cell, node, at);
        link(cell, node, own, side, at);
      }
      linker.nextNode();
    }
    linker.end();
  }

  private void link(GraphCell cell, int node, double own, Side side, int[] at) {
    int axis = side.axis();
    int beyond = at[axis] + side.outwards();
    at[axis] = problem.ends(axis).wrap(beyond, problem.extent(axis));
    if (at[axis] >= 0) {
      long key = CellKey.of(at[0] / EDGE, at[1] / EDGE, at[2] / EDGE);
      GraphCell other = key == cell.key ? cell : cells.get(key);
      int otherNode = other == null ? -1 : node(other, at[0], at[1], at[2]);
      if (otherNode >= 0) {
        double mobility =
            other == cell
                ? mobilities[other.position[otherNode]]
                : problem.mobility(at[0], at[1], at[2]);
        linker.link(other, otherNode, problem.link(own, mobility));
      } else if (problem.hasFixedWalls()) {
        fix(cell, node, own, problem.wallValue());
      }
    } else if (problem.isFixed(side)) {
      fix(cell, node, own, problem.value(side));
    }
  }

  /** A link over half a spacing to a fixed value. */
  private void fix(GraphCell cell, int node, double own, double value) {
    linker.ground(2 * own);
    if (cell.fixedSource == null) {
      cell.fixedSource = new double[cell.nodes];
    }
    cell.fixedSource[node] += 2 * own * value;
  }

  /** Number of the node at (x, y, z) within its cell, negative if it is not active. */
  static int node(GraphCell cell, int x, int y, int z) {
    int position = x % EDGE + EDGE * (y % EDGE + EDGE * (z % EDGE));
    return Arrays.binarySearch(cell.position, (char) position);
  }

  /** Coordinates of a node in the box of the problem. */
  static void coordinates(GraphCell cell, int node, int[] into) {
    int position = cell.position[node];
    into[0] = CellKey.i(cell.key) * EDGE + position % EDGE;
    into[1] = CellKey.j(cell.key) * EDGE + position / EDGE % EDGE;
    into[2] = CellKey.k(cell.key) * EDGE + position / (EDGE * EDGE);
  }
}
