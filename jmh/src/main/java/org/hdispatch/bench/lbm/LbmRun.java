package org.hdispatch.bench.lbm;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.VelocitySet;

/** A lattice driven by a body force along x, TRT at tau 1, its workers running. */
final class LbmRun implements AutoCloseable {
  /** Weak: the flow stays slow however long the benchmark runs. */
  private static final BodyForce FORCE = new BodyForce(1e-7, 0, 0);

  private final Dispatcher dispatcher;
  private final LbmScheme scheme;
  private final TimeLoop loop;

  LbmRun(Lattice lattice, VelocitySet velocitySet, String bundle, int workers) {
    scheme =
        LbmScheme.on(lattice)
            .velocitySet(velocitySet)
            .bundleSize(BundleSizes.parse(bundle))
            .force(FORCE)
            .build();
    dispatcher = Dispatcher.withWorkers(workers);
    loop = dispatcher.loop(scheme);
  }

  void run(int steps, NodeRate rate) {
    loop.run(steps);
    rate.mflups += steps * scheme.nodes();
  }

  @Override
  public void close() {
    dispatcher.close();
  }
}
