package org.hdispatch.poisson;

import org.hdispatch.cell.Ends;

/** Adds the divergence of mobility times a constant force to the sources of one cell. */
final class BodyForce {
  private final PoissonProblem problem;
  private final double[] force;
  private final GraphCell cell;
  private final int[] here = new int[3];
  private final int[] there = new int[3];

  private BodyForce(PoissonProblem problem, double[] force, GraphCell cell) {
    this.problem = problem;
    this.force = force;
    this.cell = cell;
  }

  /**
   * Adds minus the flux that the force drives out of each node.
   *
   * @param factor of all mobilities
   */
  static void add(PoissonProblem problem, GraphCell cell, double[] force, double factor) {
    BodyForce body = new BodyForce(problem, force, cell);
    for (int m = 0; m < cell.nodes; m++) {
      FineCells.coordinates(cell, m, body.here);
      double flux = body.flux(m, cell.lower) + body.flux(m, cell.upper) + body.ends(m);
      cell.source[m] -= factor * flux;
    }
    body.addHalo(factor);
  }

  private double flux(int node, Links links) {
    double flux = 0;
    for (int n = links.begin(node); n < links.end(node); n++) {
      FineCells.coordinates(cell, links.to()[n], there);
      flux += links.mobility()[n] * along();
    }
    return flux;
  }

  private void addHalo(double factor) {
    HaloLinks halo = cell.halo;
    for (int c = 0, n = 0; c < halo.cells().length; c++) {
      for (; n < halo.end()[c]; n++) {
        FineCells.coordinates(cell, halo.row()[n], here);
        FineCells.coordinates(halo.cells()[c], halo.to()[n], there);
        cell.source[halo.row()[n]] -= factor * halo.mobility()[n] * along();
      }
    }
  }

  /** Force times the way from here to there. */
  private double along() {
    return force[0] * step(0) + force[1] * step(1) + force[2] * step(2);
  }

  /** How far the other end of a link lies along an axis, through a periodic end if it is nearer. */
  private int step(int axis) {
    int step = there[axis] - here[axis];
    if (problem.ends(axis) == Ends.PERIODIC && step != 0) {
      int extent = problem.extent(axis);
      if (extent == 2) {
        return 0; // linked to both sides, the force drives as much in as out
      }
      return step == extent - 1 ? -1 : step == 1 - extent ? 1 : step;
    }
    return step;
  }

  /** Out of fixed sides, half a spacing away: half the force times twice the mobility. */
  private double ends(int node) {
    if (cell.ground == null || cell.ground[node] == 0) {
      return 0;
    }
    if (problem.mobilities() > 1) {
      return endsByAxis();
    }
    int sides = 0;
    double outwards = 0;
    for (Side side : Side.ALL) {
      if (isFixedBeside(side)) {
        sides++;
        outwards += side.outwards() * force[side.axis()];
      }
    }
    return cell.ground[node] / (2 * sides) * outwards;
  }

  /** The same where each axis has a mobility of its own. */
  private double endsByAxis() {
    double flux = 0;
    for (Side side : Side.ALL) {
      if (isFixedBeside(side)) {
        int axis = side.axis();
        double mobility = problem.mobility(axis, here[0], here[1], here[2]);
        flux += mobility * side.outwards() * force[axis];
      }
    }
    return flux;
  }

  private boolean isFixedBeside(Side side) {
    int last = side.outwards() < 0 ? 0 : problem.extent(side.axis()) - 1;
    return problem.isFixed(side) && here[side.axis()] == last;
  }
}
