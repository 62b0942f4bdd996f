package org.hdispatch.lbm.immersed;

import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Relaxation;
import org.hdispatch.lbm.VelocitySet;

/** Small flows that several tests share. */
final class ImmersedFlows {
  private ImmersedFlows() {}

  static Lattice periodic(int nx, int ny, int nz) {
    return Lattice.empty(nx, ny, nz, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
  }

  /** Sum over all nodes of the momentum after collision, along x. */
  static double momentum(LbmScheme scheme) {
    double[] sum = new double[1];
    scheme.forEachNode((x, y, z, density, ux, uy, uz) -> sum[0] += ux);
    return sum[0] + scheme.nodes() * scheme.force().x() / 2;
  }

  /** Permeability along x of Stokes flow, D3Q15, BGK at tau 0.6, in node spacings². */
  static double permeability(Lattice lattice, Body... bodies) {
    return permeability(Relaxation.bgk(0.6), lattice, bodies);
  }

  static double permeability(Relaxation relaxation, Lattice lattice, Body... bodies) {
    double g = 1e-6;
    LbmScheme scheme =
        LbmScheme.on(lattice)
            .velocitySet(VelocitySet.D3Q15)
            .equilibrium(Equilibrium.LINEAR)
            .relaxation(relaxation)
            .force(new BodyForce(g, 0, 0))
            .immersion(ImmersedBodies.of(bodies))
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      double before = Double.NaN;
      for (int block = 0; block < 1_000; block++) {
        loop.run(200);
        double now = momentum(scheme);
        if (Math.abs(now - before) < 1e-6 * now) {
          return now / scheme.nodes() * scheme.relaxation().viscosity() / g;
        }
        before = now;
      }
      throw new AssertionError("no steady state");
    }
  }
}
