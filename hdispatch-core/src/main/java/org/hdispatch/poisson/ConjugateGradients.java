package org.hdispatch.poisson;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.KernelException;
import org.hdispatch.poisson.Level.Task;

/**
 * Solves a {@link PoissonProblem} by conjugate gradients, preconditioned by aggregation multigrid;
 * all passes run on the enduring threads of a dispatcher.
 *
 * <p>Sources and solution are 0 at first. A solution stays as the first guess of the next solve.
 * Where no fixed side is in reach, p is known up to a constant for each connected cluster: its mean
 * is then 0 there, and so must be the sum of the sources; what is left of that is spread over the
 * cluster's nodes and taken away, see {@link Convergence#imbalance}.
 *
 * <p>A solve allocates nothing on any thread after warm-up, and every bit of the solution is the
 * same for any number of workers and any order of hand-out.
 *
 * <p>Workers ask mobilities, fields and link means, several at a time and each for nodes of its
 * own: what they answer must depend on the node alone. What such a function throws comes as a
 * {@link KernelException}, an {@code IllegalArgumentException} as itself. All that runs on workers
 * ends as {@link #solve} does when the caller is interrupted, and may have come to some cells only.
 *
 * <p>Not for several threads at a time.
 */
public final class ConjugateGradients {
  private final PoissonProblem problem;
  private final CellMap<GraphCell> cells;
  private final Clusters clusters;
  private final Cycle cycle;
  private double factor = 1;

  private ConjugateGradients(Dispatcher dispatcher, PoissonProblem problem) {
    this.problem = problem;
    cells = FineCells.of(dispatcher, problem);
    clusters = new Clusters(dispatcher, cells);
    cycle = new Cycle(cells, clusters, dispatcher);
  }

  /**
   * Makes the cells of a problem and all storage that solving takes; the workers link them.
   *
   * @throws IllegalArgumentException if a mobility is negative, infinite or not a number
   * @throws ArithmeticException if the active nodes number 2^31 or more
   */
  public static ConjugateGradients on(Dispatcher dispatcher, PoissonProblem problem) {
    return new ConjugateGradients(dispatcher, problem);
  }

  /** Sets all sources to 0. */
  public void clearSources() {
    cycle.finest().run(cell -> Arrays.fill(cell.source, 0));
  }

  /**
   * Adds to the source b of every active node.
   *
   * @throws IllegalArgumentException if a value is infinite or not a number
   */
  public void addSources(NodeField field) {
    cycle.finest().run(cell -> Fields.addSources(cell, field));
  }

  /**
   * Adds what a constant force drives, so that p is the pressure that goes with it: with forces
   * alone, sum of k_mn (p_m - p_n + g . e_mn) = 0, e_mn being the way from m to n.
   *
   * @param gx force along x, in units of p per spacing
   * @param gy force along y
   * @param gz force along z
   * @throws IllegalArgumentException if a component is infinite or not a number
   * @throws IllegalStateException if the problem has fixed walls
   */
  public void addForce(double gx, double gy, double gz) {
    if (!Double.isFinite(gx) || !Double.isFinite(gy) || !Double.isFinite(gz)) {
      throw new IllegalArgumentException(
          "force must be finite: gx=" + gx + ", gy=" + gy + ", gz=" + gz);
    }
    if (problem.hasFixedWalls()) {
      throw new IllegalStateException(
          "walls must be closed to flow where a force acts: value on walls=" + problem.wallValue());
    }
    double[] force = {gx, gy, gz};
    cycle.finest().run(cell -> BodyForce.add(problem, cell, force, factor));
  }

  /**
   * Multiplies all mobilities, those of fixed sides too, from the next solve or force on; costs
   * nothing. The factor counts from the mobilities given at first.
   *
   * @throws IllegalArgumentException if it is not positive and finite
   */
  public void scaleMobility(double times) {
    if (!(times > 0 && times <= Double.MAX_VALUE)) {
      throw new IllegalArgumentException(
          "factor of mobility must be positive and finite: factor=" + times);
    }
    factor = times;
  }

  /** Sets the solution to 0, for a start from there. */
  public void clearSolution() {
    cycle.finest().run(cell -> Arrays.fill(cell.solution, 0));
  }

  /**
   * Sets the first guess.
   *
   * @throws IllegalArgumentException if a value is infinite or not a number
   */
  public void guess(NodeField field) {
    cycle.finest().run(cell -> Fields.guess(cell, field));
  }

  /**
   * Solves until the norm of the residual is at most {@code tolerance} times that of the balanced
   * right-hand side, the fixed values included. Without any source the solution is 0.
   *
   * @param tolerance positive; below about 1e-13 rounding errors may stand in the way
   * @param maxIterations at most so many iterations
   * @throws IllegalArgumentException if the tolerance is not positive or the number negative
   * @throws ArithmeticException if numbers grow beyond all bounds
   * @throws CancellationException if the caller was interrupted or the dispatcher closed; then some
   *     cells may have made a move that others have not, and the next solve starts from there
   * @throws KernelException if a worker fails, as for want of stack
   * @throws IllegalStateException if the dispatcher is running a loop already or is closed
   */
  public Convergence solve(double tolerance, int maxIterations) {
    if (!(tolerance > 0)) {
      throw new IllegalArgumentException("tolerance must be positive: tolerance=" + tolerance);
    }
    if (maxIterations < 0) {
      throw new IllegalArgumentException(
          "number of iterations must not be negative: iterations=" + maxIterations);
    }
    Level level = cycle.finest();
    double imbalance = clusters.balance(level);
    level.sourceFactor = 1 / factor;
    level.run(Task.BEGIN);
    double sources = level.sum(1);
    if (sources == 0) {
      clearSolution();
      return new Convergence(0, 0, true, imbalance);
    }
    level.forward(0);
    double energy = 1;
    int iteration = 0;
    double left = relative(level.sum(0), sources, iteration);
    while (left > tolerance && iteration < maxIterations) {
      double share = -cycle.precondition(0) / energy;
      level.direct(iteration == 0 ? 0 : share);
      energy = level.sum(0);
      if (!(energy > 0)) {
        break; // nothing left that rounding errors have not made
      }
      level.forward(level.sum(1) / energy);
      iteration++;
      left = relative(level.sum(0), sources, iteration);
    }
    clusters.centre(level);
    return new Convergence(iteration, left, left <= tolerance, imbalance);
  }

  private static double relative(double residual, double sources, int iteration) {
    double relative = Math.sqrt(residual / sources);
    if (!Double.isFinite(relative)) {
      throw Refusal.residual(relative, iteration);
    }
    return relative;
  }

  /**
   * The solution at a node.
   *
   * @throws IllegalArgumentException if there is no active node at (x, y, z)
   */
  public double value(int x, int y, int z) {
    int edge = FineCells.EDGE;
    boolean inside = x >= 0 && x < problem.extent(0) && y >= 0 && y < problem.extent(1);
    inside &= z >= 0 && z < problem.extent(2);
    GraphCell cell = inside ? cells.get(CellKey.of(x / edge, y / edge, z / edge)) : null;
    int node = cell == null ? -1 : FineCells.node(cell, x, y, z);
    if (node < 0) {
      throw Refusal.noNode(x, y, z);
    }
    return cell.solution[node];
  }

  /** Shows the solution at every active node, cell by cell in the order of the cells. */
  public void forEachNode(NodeVisitor visitor) {
    for (int n = 0; n < cells.size(); n++) {
      Fields.show(cells.cellAt(n), visitor);
    }
  }

  /** As {@link #forEachNode}, but several workers show nodes at the same time, in any order. */
  public void forEachNodeAtOnce(NodeVisitor visitor) {
    cycle.finest().run(cell -> Fields.show(cell, visitor));
  }

  /**
   * Sum of a field over all active nodes. Every bit is the same for any number of workers.
   *
   * @throws IllegalArgumentException if a value is infinite or not a number
   */
  public double sum(NodeField field) {
    Level level = cycle.finest();
    level.run(cell -> Fields.sum(cell, field));
    return level.sum(0);
  }

  /** Number of active nodes. */
  public long nodes() {
    return cycle.finest().nodes();
  }

  /** Number of clusters that links connect, single nodes included. */
  public int clusters() {
    return clusters.count();
  }

  /** Number of levels, the finest included. */
  public int levels() {
    return cycle.levels();
  }

  /** Bytes of the cells of all levels, without the scratch of the workers. */
  public long bytes() {
    return cycle.bytes();
  }
}
