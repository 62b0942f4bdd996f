package org.hdispatch.poisson;

import java.util.ArrayList;
import java.util.List;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.poisson.Level.Task;

/**
 * The levels, and the cycle through them that preconditions the finest: forward sweep, coarse
 * correction, backward sweep. A coarse level is itself solved by one or two iterations of conjugate
 * gradients, preconditioned in the same way ("K-cycle", Notay, Vassilevski, Numerical Linear
 * Algebra with Applications 15, 2008, 473-487).
 */
final class Cycle {
  /*
   * What was compared before this was chosen: iterations to 1e-8 (and fine matrix-vector products'
   * worth of arithmetic in an iteration, the outer one included), in a plain prototype with
   * aggregates and cells as here. Constant: random sources, periodic. Berea: block 6 of the 128³
   * blocks, mobility = square of the city-block distance to the wall, a force along periodic z.
   *
   *   smoother, cycle                                 constant 64³   128³       Berea 128³
   *   Gauss-Seidel in cells, K-cycle (chosen)         12 (4.6)   12 (4.6)   22 (5.2)
   *   the same, V-cycle                                                      177 (4.0)
   *   the same, V-cycle, corrections times 1.8        13 (3.9)   14 (3.9)   83 (4.0)
   *   the same, K-cycle on the first two levels only                        42 (5.0)
   *   the same, K-cycle, links < 1/4 of the strongest not aggregated       20 (5.3)
   *   Gauss-Seidel forward and backward, twice, K-cycle, times 1.5          16 (7.6)
   *   Chebyshev of degree 2 on [1/4, 2], K-cycle                             18 (7.4)
   *   the same, V-cycle, corrections times 1.8        10 (5.6)   10 (5.6)
   *
   * So constant mobility would do without the K-cycle, rock does not.
   */
  /** A coarse iteration that leaves less of the residual than this is the last. */
  private static final double ENOUGH = 0.25;

  private final List<Level> levels = new ArrayList<>();
  private final DirectSolver coarsest; // null if the last level has too many nodes

  Cycle(CellMap<GraphCell> fine, Clusters clusters, Dispatcher dispatcher) {
    CellMap<GraphCell> cells = fine;
    int edge = FineCells.EDGE;
    while (true) {
      long nodes = nodes(cells);
      CoarseCells.Coarser coarser =
          nodes <= DirectSolver.MOST_NODES ? null : CoarseCells.of(dispatcher, cells, edge, nodes);
      levels.add(new Level(cells, levels.isEmpty() ? clusters : null, dispatcher));
      if (coarser == null) {
        coarsest = nodes <= DirectSolver.MOST_NODES ? new DirectSolver(cells) : null;
        return;
      }
      cells = coarser.cells();
      edge = coarser.edge();
    }
  }

  private static long nodes(CellMap<GraphCell> cells) {
    long nodes = 0;
    for (int n = 0; n < cells.size(); n++) {
      nodes += cells.cellAt(n).nodes;
    }
    return nodes;
  }

  Level finest() {
    return levels.get(0);
  }

  /**
   * Preconditions the residual of a level, which has been swept forward.
   *
   * @return preconditioned . product
   */
  double precondition(int number) {
    Level level = levels.get(number);
    if (number < levels.size() - 1) {
      level.run(Task.RESTRICT);
      solve(number + 1);
      level.run(Task.BACKWARD);
    } else if (coarsest == null) {
      level.run(Task.BACKWARD);
    } else {
      coarsest.precondition();
    }
    return level.sum(0);
  }

  /** Solves a coarse level approximately for the restricted residual. */
  private void solve(int number) {
    Level level = levels.get(number);
    level.run(Task.COLLECT);
    if (number == levels.size() - 1 && coarsest != null) {
      coarsest.solveForSolution();
      return;
    }
    double initial = level.sum(0);
    if (initial == 0) {
      return;
    }
    level.forward(0);
    precondition(number);
    level.direct(0);
    double energy = level.sum(0);
    if (!(energy > 0)) {
      return;
    }
    double alpha = level.sum(1) / energy;
    double left = initial - alpha * (2 * level.sum(2) - alpha * level.sum(3));
    if (left > ENOUGH * ENOUGH * initial) {
      level.forward(alpha);
      level.direct(-precondition(number) / energy);
      energy = level.sum(0);
      alpha = energy > 0 ? level.sum(1) / energy : 0;
    }
    level.finish(alpha);
  }

  int levels() {
    return levels.size();
  }

  long bytes() {
    return levels.stream().mapToLong(Level::bytes).sum();
  }
}
