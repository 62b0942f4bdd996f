package org.hdispatch.lbm;

import java.util.function.ToDoubleFunction;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;

/** Small flows that several tests share. */
final class Flows {
  private Flows() {}

  /** A plane channel: walls at both ends of y, one node along x and z. */
  static Lattice channel(int width) {
    return Lattice.empty(1, width, 1, Ends.PERIODIC, Ends.OPEN, Ends.PERIODIC);
  }

  /** A square duct along x: walls at the ends of y and z, one node along x. */
  static Lattice duct(int width) {
    return Lattice.empty(1, width, width, Ends.PERIODIC, Ends.OPEN, Ends.OPEN);
  }

  /** Steps until the sum of ux changes by less than this share in 100 steps. */
  static TimeLoop toSteadyState(Dispatcher dispatcher, LbmScheme scheme, double change) {
    TimeLoop loop = dispatcher.loop(scheme);
    double before = Double.NaN;
    for (int block = 0; block < 2_000; block++) {
      loop.run(100);
      double now = sum(scheme, loop, u -> u[0]);
      if (Math.abs(now - before) < change * Math.abs(now)) {
        return loop;
      }
      before = now;
    }
    throw new AssertionError("no steady state");
  }

  /** Sum over all fluid nodes of a function of {ux, uy, uz, density}. */
  static double sum(LbmScheme scheme, TimeLoop loop, ToDoubleFunction<double[]> of) {
    double[] sum = new double[1];
    scheme.forEachNode(
        (x, y, z, density, ux, uy, uz) ->
            sum[0] += of.applyAsDouble(new double[] {ux, uy, uz, density}));
    return sum[0];
  }
}
