package org.hdispatch.porous.flow;

import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.poisson.ConjugateGradients;
import org.hdispatch.poisson.LinkMean;
import org.hdispatch.poisson.NodeField;
import org.hdispatch.poisson.NodeVisitor;
import org.hdispatch.poisson.PoissonProblem;
import org.hdispatch.poisson.Side;
import org.hdispatch.porous.image.Axis;

/**
 * Flow by Darcy's law from node to node: u = K/nu (g - grad p), div u = sources, a Laplace problem
 * on the fluid nodes of a domain, whatever method it is then used by. The mobility K of a node is
 * that of its {@link ChordProfile}: in a slit it is the flow itself.
 *
 * <p>Every bit is the same for any number of workers.
 */
final class DarcyFlow {
  private static final double START_TOLERANCE = 1e-3;
  private static final double CORRECTION_TOLERANCE = 0.3;
  private static final int MOST_ITERATIONS = 100;

  private final FlowDomain domain;
  private final Lattice lattice;
  private final Axis axis;
  private final double viscosity;
  private final double[] mobility; // by node, voxel²; 0 in the solid
  private final double[] field; // by node: a pressure over density
  private final ConjugateGradients solver;
  private final NodeVisitor copy; // of a solution into the field
  private double force; // that goes with the pressure in the field
  private double scale; // of all mobilities
  private double startFlux;

  /**
   * Sets the problem up.
   *
   * @param viscosity kinematic viscosity, voxel²/step
   */
  DarcyFlow(Dispatcher dispatcher, FlowDomain domain, double viscosity) {
    this.domain = domain;
    this.viscosity = viscosity;
    lattice = domain.lattice();
    axis = domain.axis();
    field = new double[Math.multiplyExact(lattice.nx() * lattice.ny(), lattice.nz())];
    mobility = new double[field.length];
    ChordProfile.find(dispatcher, domain, mobility);
    PoissonProblem.Builder between =
        PoissonProblem.box(lattice.nx(), lattice.ny(), lattice.nz())
            .ends(lattice.x(), lattice.y(), lattice.z())
            .mobility((x, y, z) -> mobility[index(x, y, z)]);
    for (Side side : Side.values()) {
      if (domain.isPressed(side.axis())) {
        between.fixed(side, 0); // what drives the flow is the force
      }
    }
    solver = ConjugateGradients.on(dispatcher, between.build());
    copy = (x, y, z, p) -> field[index(x, y, z)] = p;
  }

  private int index(int x, int y, int z) {
    return x + lattice.nx() * (y + lattice.ny() * z);
  }

  /**
   * Pressure over density by node, x fastest: what was found last. It is the caller's until the
   * next solution: what is to be a source may be gathered in it.
   */
  double[] field() {
    return field;
  }

  /**
   * Finds the flow that a body force drives.
   *
   * @param bodyForce along the flow
   */
  void start(double bodyForce) {
    force = bodyForce;
    scale = 1;
    solver.clearSources();
    solver.clearSolution();
    solver.addForce(
        axis == Axis.X ? force : 0, axis == Axis.Y ? force : 0, axis == Axis.Z ? force : 0);
    solver.solve(START_TOLERANCE, MOST_ITERATIONS);
    solver.forEachNodeAtOnce(copy);
    startFlux =
        solver.sum((x, y, z) -> velocity(x, y, z, axis))
            / axis.length(lattice.nx(), lattice.ny(), lattice.nz());
  }

  /**
   * Sets the sources: what gathers in the flow so far.
   *
   * @param gathering share of a node's volume that it gains in a step
   * @param flux through a section now: what the mobilities are scaled to
   * @return root of the sum of the squares of all sources
   */
  double gather(NodeField gathering, double flux) {
    force = 0;
    scale = Math.max(0.1, Math.min(10, flux / startFlux));
    solver.clearSources();
    solver.clearSolution();
    solver.scaleMobility(scale);
    NodeField sources = (x, y, z) -> viscosity * gathering.at(x, y, z);
    solver.addSources(sources);
    return Math.sqrt(solver.sum((x, y, z) -> square(sources.at(x, y, z))));
  }

  private static double square(double x) {
    return x * x;
  }

  /** Finds the flow that drives away what gathers. */
  void correct() {
    solver.solve(CORRECTION_TOLERANCE, MOST_ITERATIONS);
    solver.forEachNodeAtOnce(copy);
  }

  /** Pressure over density of a node, as found last. */
  double pressure(int x, int y, int z) {
    return field[index(x, y, z)];
  }

  /** The flow that goes with the pressure in the field: mean over the two faces of a node. */
  double velocity(int x, int y, int z, Axis way) {
    int here = index(x, y, z);
    int at = way.length(x, y, z);
    double in = drop(here, at, -1, way);
    double out = drop(here, at, 1, way);
    return scale / (2 * viscosity) * (in - out);
  }

  /**
   * Mobility times what drives fluid in from a neighbour, 0 from a wall.
   *
   * @param here index of the node
   * @param at its place along the way
   * @param step to the neighbour, along the way
   */
  private double drop(int here, int at, int step, Axis way) {
    int beside = at + step;
    int extent = way.length(lattice.nx(), lattice.ny(), lattice.nz());
    double driven = way == axis ? -step * force : 0;
    if (beside < 0 || beside == extent) {
      Ends ends = way == Axis.X ? lattice.x() : way == Axis.Y ? lattice.y() : lattice.z();
      beside = ends.wrap(beside, extent);
      if (beside < 0) { // half way to the plenum, at twice the mobility
        return domain.isPressed(way.ordinal()) ? mobility[here] * (driven - 2 * field[here]) : 0;
      }
    }
    int stride = way == Axis.X ? 1 : way == Axis.Y ? lattice.nx() : lattice.nx() * lattice.ny();
    int there = here + (beside - at) * stride;
    if (mobility[there] == 0) {
      return 0;
    }
    double fall = field[there] - field[here] + driven;
    return LinkMean.HARMONIC.of(mobility[here], mobility[there]) * fall;
  }
}
