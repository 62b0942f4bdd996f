package org.hdispatch.poisson;

import java.util.Arrays;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;

/**
 * Cuts the active nodes of a problem into cells of {@link #EDGE}³ nodes, and links them, in two
 * passes. Boxes without active nodes get no cell.
 */
final class FineCells {
  /** Nodes along an edge of a cell: vectors and links of a cell fit into the cache of a core. */
  static final int EDGE = 16;

  private static final int BOX = EDGE * EDGE * EDGE;
  private static final int[] STRIDES = {1, EDGE, EDGE * EDGE};

  private final PoissonProblem problem;
  private final int mobilities; // of a node
  private final CellMap<Box> boxes;
  private final CellMap<GraphCell> cells;

  private FineCells(Dispatcher dispatcher, PoissonProblem problem) {
    this.problem = problem;
    mobilities = problem.mobilities();
    int[] extents = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      extents[axis] = (problem.extent(axis) + EDGE - 1) / EDGE;
    }
    CellGrid grid = CellGrid.of(extents[0], extents[1], extents[2], Ends.OPEN);
    boxes = CellMap.fixed(grid.keys(), KeyOrder.MORTON, Box::new);
    Passes.once(dispatcher, boxes, () -> new Scratch(mobilities), this::look);
    long[] keys = Arrays.stream(grid.keys()).filter(key -> boxes.get(key).cell != null).toArray();
    cells = CellMap.fixed(keys, KeyOrder.MORTON, key -> boxes.get(key).cell);
    Passes.once(dispatcher, cells, () -> new Scratch(mobilities), this::link);
  }

  static CellMap<GraphCell> of(Dispatcher dispatcher, PoissonProblem problem) {
    return new FineCells(dispatcher, problem).cells;
  }

  /** A box of nodes; with what is found there. */
  private static final class Box {
    private final long key;
    private GraphCell cell; // null without active nodes
    private double[] mobility; // of the nodes of the cell, those of one node side by side

    Box(long key) {
      this.key = key;
    }
  }

  /** What a worker needs for one box. */
  private static final class Scratch {
    final double[] mobility; // by node
    final char[] position = new char[BOX]; // by node
    final char[] number = new char[BOX]; // by position; NONE: no active node
    final CellLinker linker = new CellLinker();

    Scratch(int mobilities) {
      mobility = new double[mobilities * BOX];
    }
  }

  /** Finds the active nodes of a box, in increasing position, and makes its cell. */
  private void look(Box box, Scratch scratch) {
    int x0 = CellKey.i(box.key) * EDGE;
    int y0 = CellKey.j(box.key) * EDGE;
    int z0 = CellKey.k(box.key) * EDGE;
    int nodes = 0;
    for (int z = 0; z < Math.min(EDGE, problem.extent(2) - z0); z++) {
      for (int y = 0; y < Math.min(EDGE, problem.extent(1) - y0); y++) {
        for (int x = 0; x < Math.min(EDGE, problem.extent(0) - x0); x++) {
          boolean active = false;
          for (int which = 0; which < mobilities; which++) {
            double mobility = problem.mobility(which, x0 + x, y0 + y, z0 + z);
            scratch.mobility[mobilities * nodes + which] = mobility;
            active |= mobility > 0;
          }
          if (active) {
            scratch.position[nodes++] = (char) (x + EDGE * (y + EDGE * z));
          }
        }
      }
    }
    if (nodes > 0) {
      box.mobility = Arrays.copyOf(scratch.mobility, mobilities * nodes);
      box.cell = new GraphCell(box.key, Arrays.copyOf(scratch.position, nodes));
      box.cell.source = new double[nodes];
    }
  }

  private void link(GraphCell cell, Scratch scratch) {
    double[] mobility = boxes.get(cell.key).mobility;
    Arrays.fill(scratch.number, GraphCell.NONE);
    for (int node = 0; node < cell.nodes; node++) {
      scratch.number[cell.position[node]] = (char) node;
    }
    CellLinker linker = scratch.linker;
    linker.begin(cell);
    int[] at = new int[3];
    for (int node = 0; node < cell.nodes; node++) {
      coordinates(cell, node, at);
      linkNode(cell, node, at, mobility, scratch);
      linker.nextNode();
    }
    linker.end();
  }

  /** Links one node: a method of its own, for it to be compiled soon. */
  private void linkNode(GraphCell cell, int node, int[] at, double[] mobility, Scratch scratch) {
    for (Side side : Side.ALL) {
      int axis = side.axis();
      double own = along(axis, mobility, node);
      int here = at[axis];
      int beyond = here + side.outwards();
      if (beyond < 0 || beyond == problem.extent(axis) || leaves(here, side)) {
        linkOutside(cell, node, own, side, at, scratch.linker);
        at[axis] = here;
        continue;
      }
      int other = scratch.number[cell.position[node] + side.outwards() * STRIDES[axis]];
      if (other != GraphCell.NONE) {
        scratch.linker.link(cell, other, problem.link(own, along(axis, mobility, other)));
      } else {
        wall(cell, node, own, scratch.linker);
      }
    }
  }

  /** Mobility of a node along an axis. */
  private double along(int axis, double[] mobility, int node) {
    return mobility[mobilities == 1 ? node : mobilities * node + axis];
  }

  /** Whether the neighbour on a side lies in another box. */
  private static boolean leaves(int at, Side side) {
    return at % EDGE == (side.outwards() < 0 ? 0 : EDGE - 1);
  }

  /** Links a node to what lies beside its box; {@code at} is the node, and then what lies there. */
  private void linkOutside(
      GraphCell cell, int node, double own, Side side, int[] at, CellLinker linker) {
    int axis = side.axis();
    at[axis] = problem.ends(axis).wrap(at[axis] + side.outwards(), problem.extent(axis));
    if (at[axis] >= 0) {
      Box box = boxes.get(CellKey.of(at[0] / EDGE, at[1] / EDGE, at[2] / EDGE));
      int other = box.cell == null ? -1 : node(box.cell, at[0], at[1], at[2]);
      if (other >= 0) {
        linker.link(box.cell, other, problem.link(own, along(axis, box.mobility, other)));
      } else {
        wall(cell, node, own, linker);
      }
    } else if (problem.isFixed(side)) {
      fix(cell, node, own, problem.value(side), linker);
    }
  }

  /** What a node that is not active means for its neighbour. */
  private void wall(GraphCell cell, int node, double own, CellLinker linker) {
    if (problem.hasFixedWalls()) {
      fix(cell, node, own, problem.wallValue(), linker);
    }
  }

  /** A link over half a spacing to a fixed value. */
  private static void fix(GraphCell cell, int node, double own, double value, CellLinker linker) {
    if (own == 0) {
      return;
    }
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
