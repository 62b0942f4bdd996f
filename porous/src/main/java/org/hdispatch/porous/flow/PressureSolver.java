package org.hdispatch.porous.flow;

import java.util.function.BiConsumer;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.NodalBundle;
import org.hdispatch.porous.image.Axis;

/**
 * Gives a lattice Boltzmann flow the pressure that it is still looking for.
 *
 * <p>In the lattice Boltzmann method pressure diffuses; in tight rock that takes tens of thousands
 * of steps. Here it follows from {@link DarcyFlow}:
 *
 * <ul>
 *   <li>At the start the fluid gets that pressure and that velocity.
 *   <li>From time to time the rate at which mass still gathers at the nodes is taken as a source.
 *       The pressure that drives it away, and the flow that goes with it, are added in part. It is
 *       the pressure correction of SIMPLE, with the lattice Boltzmann method as momentum step.
 * </ul>
 */
final class PressureSolver {
  /** Heap that a fluid node takes: its links and vectors on all levels. */
  static final int BYTES_PER_NODE = 200;

  /** Heap that a voxel takes: mobility and field. */
  static final int BYTES_PER_VOXEL = 2 * Double.BYTES;

  private final LbmScheme flow;
  private final Lattice lattice;
  private final DarcyFlow darcy;
  private final CorrectionShare correction = new CorrectionShare();
  private final TimeLoop noteDensity;
  private final TimeLoop addPressure;
  private double share; // of the flow found that is added

  PressureSolver(Dispatcher dispatcher, FlowDomain domain, LbmScheme flow) {
    this.flow = flow;
    lattice = domain.lattice();
    darcy = new DarcyFlow(dispatcher, domain, flow.relaxation().viscosity());
    double[] field = darcy.field();
    LbmScheme.NodeVisitor note = (x, y, z, rho, ux, uy, uz) -> field[index(x, y, z)] = -rho;
    LbmScheme.NodeChange change = this::change;
    noteDensity = loop(dispatcher, (bundle, scratch) -> flow.forEachNode(bundle, scratch, note));
    addPressure = loop(dispatcher, (bundle, scratch) -> flow.add(bundle, scratch, change));
  }

  private TimeLoop loop(Dispatcher dispatcher, BiConsumer<NodalBundle, LbmScheme.Scratch> work) {
    return dispatcher.loop(
        Scheme.of(flow.cells())
            .scratch(flow::newScratch)
            .pass("pressure", (bundle, scratch, tick) -> work.accept(bundle, scratch))
            .build());
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
    darcy.start(bodyForce);
    share = 1;
    addPressure.run(1);
  }

  /** Notes the density of all nodes. */
  void noteDensity() {
    noteDensity.run(1);
  }

  /**
   * Sees the density of a node now, once since {@link #noteDensity}; safe for several workers.
   *
   * @param density rho
   */
  void seeDensity(int x, int y, int z, double density) {
    darcy.field()[index(x, y, z)] += density;
  }

  /**
   * Adds the pressure that drives away what the nodes have gained since {@link #noteDensity}, all
   * of them {@linkplain #seeDensity seen}, and the flow that goes with it, as far as {@link
   * CorrectionShare} allows.
   *
   * @param steps since then; an even number, in which what changes sign from step to step is gone
   * @param flux through a section now: what the mobilities are scaled to
   */
  void correct(int steps, double flux) {
    correction.judge(darcy.gather((x, y, z) -> darcy.pressure(x, y, z) / steps, flux));
    if (!helpful()) {
      return;
    }
    darcy.correct();
    share = correction.share();
    addPressure.run(1);
  }

  /** Whether corrections are still made. */
  boolean helpful() {
    return correction.helpful();
  }

  /** What the pressure found adds to the state of a node. */
  private void change(int x, int y, int z, LbmScheme.NodeState state) {
    state.density = share * 3 * darcy.pressure(x, y, z);
    state.ux = share * darcy.velocity(x, y, z, Axis.X);
    state.uy = share * darcy.velocity(x, y, z, Axis.Y);
    state.uz = share * darcy.velocity(x, y, z, Axis.Z);
  }
}
