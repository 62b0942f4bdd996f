package org.hdispatch.porous.flow;

import java.util.function.BiConsumer;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.NodalBundle;
import org.hdispatch.poisson.ConjugateGradients;
import org.hdispatch.poisson.LinkMean;
import org.hdispatch.poisson.PoissonProblem;
import org.hdispatch.poisson.Side;
import org.hdispatch.porous.image.Axis;

/**
 * Finds the pressure that a flow is still looking for.
 *
 * <p>In the lattice Boltzmann method pressure diffuses; in tight rock that takes tens of thousands
 * of steps. Here it follows from Darcy's law from node to node: u = K/nu (g - grad p), div u = 0, a
 * Laplace problem on the fluid nodes. The mobility K of a node is the profile of laminar flow
 * through its pore, laplacian K = -1 with K = 0 on the walls: in a slit it is the flow itself.
 *
 * <ul>
 *   <li>At the start the fluid gets that pressure and that velocity.
 *   <li>From time to time the rate at which mass still gathers at the nodes is taken as a source.
 *       The pressure that drives it away, and the flow that goes with it, are added in part. It is
 *       the pressure correction of SIMPLE, with the lattice Boltzmann method as momentum step.
 * </ul>
 *
 * <p>Every bit is the same for any number of workers.
 */
final class PressureSolver {
  /** Heap that a fluid node takes: its links and vectors on all levels. */
  static final int BYTES_PER_NODE = 200;

  /** Heap that a voxel takes: mobility and field. */
  static final int BYTES_PER_VOXEL = 2 * Double.BYTES;

  private static final double START_TOLERANCE = 1e-3;
  private static final double CORRECTION_TOLERANCE = 0.1;
  private static final int MOST_ITERATIONS = 100;

  /** Share of a correction that is added; more than all of it overshoots. */
  private static final double SHARE = 0.9;

  private final FlowDomain domain;
  private final LbmScheme flow;
  private final Lattice lattice;
  private final Axis axis;
  private final double[] mobility; // by node, voxel²; 0 in the solid
  private final double[] field; // by node: a pressure over density, or a gain of density
  private final ConjugateGradients solver;
  private final TimeLoop noteDensity;
  private final TimeLoop addGain;
  private final TimeLoop addPressure;
  private double force; // that goes with the pressure in the field
  private double share; // of it that is added
  private double leastGathered = Double.POSITIVE_INFINITY;
  private double scale; // of all mobilities
  private double startFlux;

  PressureSolver(Dispatcher dispatcher, FlowDomain domain, LbmScheme flow) {
    this.domain = domain;
    this.flow = flow;
    lattice = domain.lattice();
    axis = domain.axis();
    field = new double[Math.multiplyExact(lattice.nx() * lattice.ny(), lattice.nz())];
    mobility = profiles(dispatcher);
    PoissonProblem.Builder between = problem().mobility((x, y, z) -> mobility[index(x, y, z)]);
    for (Side side : Side.values()) {
      if (domain.isPressed(side.axis())) {
        between.fixed(side, 0); // what drives the flow is the force
      }
    }
    solver = ConjugateGradients.on(dispatcher, between.build());
    LbmScheme.NodeVisitor note = (x, y, z, rho, ux, uy, uz) -> field[index(x, y, z)] = -rho;
    LbmScheme.NodeVisitor gain = (x, y, z, rho, ux, uy, uz) -> field[index(x, y, z)] += rho;
    LbmScheme.NodeChange change = this::change;
    noteDensity = loop(dispatcher, (bundle, scratch) -> flow.forEachNode(bundle, scratch, note));
    addGain = loop(dispatcher, (bundle, scratch) -> flow.forEachNode(bundle, scratch, gain));
    addPressure = loop(dispatcher, (bundle, scratch) -> flow.add(bundle, scratch, change));
  }

  private TimeLoop loop(Dispatcher dispatcher, BiConsumer<NodalBundle, LbmScheme.Scratch> work) {
    return dispatcher.loop(
        Scheme.of(flow.cells())
            .scratch(flow::newScratch)
            .pass("pressure", (bundle, scratch, tick) -> work.accept(bundle, scratch))
            .build());
  }

  private PoissonProblem.Builder problem() {
    return PoissonProblem.box(lattice.nx(), lattice.ny(), lattice.nz())
        .ends(lattice.x(), lattice.y(), lattice.z());
  }

  /**
   * The profile of laminar flow at each node. The half spacing to the wall makes the discrete one
   * too large by 1/8 at every node of a slit.
   */
  private double[] profiles(Dispatcher dispatcher) {
    PoissonProblem.Builder walled =
        problem().mobility((x, y, z) -> lattice.nodes().fluid(x, y, z) ? 1 : 0).fixedWalls(0);
    for (Side side : Side.values()) {
      if (domain.isWalled(side.axis())) {
        walled.fixed(side, 0);
      }
    }
    ConjugateGradients profile = ConjugateGradients.on(dispatcher, walled.build());
    profile.addSources((x, y, z) -> 1);
    profile.solve(START_TOLERANCE, MOST_ITERATIONS);
    double[] profiles = new double[field.length];
    profile.forEachNode(
        (x, y, z, value) -> profiles[index(x, y, z)] = Math.max(value - 0.125, value / 2));
    return profiles;
  }

  private int index(int x, int y, int z) {
    return x + lattice.nx() * (y + lattice.ny() * z);
  }

  /**
   * Puts the fluid, at rest so far, into the flow that a body force drives.
   *
   * @param bodyForce along the flow
   */
  void start(double bodyForce) {
    force = bodyForce;
    scale = 1;
    share = 1;
    solver.clearSources();
    solver.clearSolution();
    solver.addForce(
        axis == Axis.X ? force : 0, axis == Axis.Y ? force : 0, axis == Axis.Z ? force : 0);
    solver.solve(START_TOLERANCE, MOST_ITERATIONS);
    solver.forEachNode((x, y, z, p) -> field[index(x, y, z)] = p);
    double[] sum = new double[1];
    solver.forEachNode((x, y, z, p) -> sum[0] += velocity(x, y, z, axis));
    startFlux = sum[0] / axis.length(lattice.nx(), lattice.ny(), lattice.nz());
    addPressure.run(1);
    share = SHARE;
  }

  /** Notes the density of all nodes. */
  void noteDensity() {
    noteDensity.run(1);
  }

  /**
   * Adds the pressure that drives away what the nodes have gained since {@link #noteDensity}, and
   * the flow that goes with it; a smaller share of it when more gathers than before, and nothing
   * any more where that does not help.
   *
   * @param steps since then; an even number, in which what changes sign from step to step is gone
   * @param flux through a section now: what the mobilities are scaled to
   */
  void correct(int steps, double flux) {
    addGain.run(1);
    force = 0;
    scale = Math.max(0.1, Math.min(10, flux / startFlux));
    double rate = flow.relaxation().viscosity() / steps;
    solver.clearSources();
    solver.clearSolution();
    solver.scaleMobility(scale);
    double[] squares = new double[1];
    solver.addSources(
        (x, y, z) -> {
          double source = rate * field[index(x, y, z)];
          squares[0] += source * source;
          return source;
        });
    judge(Math.sqrt(squares[0]));
    if (!helpful()) {
      return;
    }
    solver.solve(CORRECTION_TOLERANCE, MOST_ITERATIONS);
    solver.forEachNode((x, y, z, p) -> field[index(x, y, z)] = p);
    addPressure.run(1);
  }

  /** Half as much from now on, if clearly more mass gathers than has before. */
  private void judge(double gathered) {
    if (gathered > 1.5 * leastGathered) {
      share /= 2;
    }
    leastGathered = Math.min(leastGathered, gathered);
  }

  /** Whether corrections are still made: not once their share had to be halved twice. */
  boolean helpful() {
    return share > 0.25;
  }

  /** What the pressure in the field adds to the state of a node. */
  private void change(int x, int y, int z, LbmScheme.NodeState state) {
    state.density = share * 3 * field[index(x, y, z)];
    state.ux = share * velocity(x, y, z, Axis.X);
    state.uy = share * velocity(x, y, z, Axis.Y);
    state.uz = share * velocity(x, y, z, Axis.Z);
  }

  /** The flow that goes with the pressure in the field: mean over the two faces of a node. */
  private double velocity(int x, int y, int z, Axis way) {
    int dx = way == Axis.X ? 1 : 0;
    int dy = way == Axis.Y ? 1 : 0;
    int dz = way == Axis.Z ? 1 : 0;
    double in = drop(x, y, z, x - dx, y - dy, z - dz, way);
    double out = drop(x, y, z, x + dx, y + dy, z + dz, way);
    return scale / (2 * flow.relaxation().viscosity()) * (in - out);
  }

  /** Mobility times what drives fluid in from a neighbour, 0 from a wall. */
  private double drop(int x, int y, int z, int xn, int yn, int zn, Axis way) {
    int xi = lattice.x().wrap(xn, lattice.nx());
    int yj = lattice.y().wrap(yn, lattice.ny());
    int zk = lattice.z().wrap(zn, lattice.nz());
    int here = index(x, y, z);
    double driven = way != axis ? 0 : xn < x || yn < y || zn < z ? force : -force;
    if (xi < 0 || yj < 0 || zk < 0) { // half way to the plenum, at twice the mobility
      return domain.isPressed(way.ordinal()) ? mobility[here] * (driven - 2 * field[here]) : 0;
    }
    double there = mobility[index(xi, yj, zk)];
    if (there == 0) {
      return 0;
    }
    double fall = field[index(xi, yj, zk)] - field[here] + driven;
    return LinkMean.HARMONIC.of(mobility[here], there) * fall;
  }
}
