package org.hdispatch.sph.cases;

import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.sph.SphScheme;

/** How the flows of the tests are run, and what is read from them. */
final class Flows {
  private Flows() {}

  /** Runs to about a time: to the step that ends nearest to it. */
  static double runTo(TimeLoop loop, SphScheme scheme, double time) {
    long steps = Math.round(time / scheme.timeStep());
    loop.run(steps - loop.tick().step());
    return steps * scheme.timeStep();
  }

  /** Exact velocity along x. */
  interface Exact {
    double at(double y);
  }

  /** Root of the mean square deviation of the fluid from the exact velocity. */
  static double deviation(SphScheme scheme, Exact exact) {
    double[] sums = new double[2];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          if (phase == 0) {
            double apart = u - exact.at(y);
            sums[0] += apart * apart;
            sums[1]++;
          }
        });
    return Math.sqrt(sums[0] / sums[1]);
  }
}
