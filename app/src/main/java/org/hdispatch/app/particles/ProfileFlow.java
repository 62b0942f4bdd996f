package org.hdispatch.app.particles;

import java.util.List;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.cases.FlowCase;

/**
 * A flow along x whose velocity is known everywhere and at all times.
 *
 * @param flow the flow
 * @param duration time to run
 * @param greatest velocity that deviations are compared with
 * @param exact the velocity that is right
 */
record ProfileFlow(FlowCase flow, double duration, double greatest, Exact exact)
    implements ReadyFlow {
  /** A velocity along x. */
  interface Exact {
    /** The velocity at a height and a time. */
    double at(double y, double time);
  }

  @Override
  public SphSchemeBuilder settings() {
    return flow.settings();
  }

  @Override
  public Particles particles() {
    return flow.particles();
  }

  @Override
  public double spacing() {
    return flow.lattice().spacing();
  }

  @Override
  public List<Finding> findings(SphScheme scheme, double time) {
    return of(scheme, time, greatest, exact);
  }

  /** The velocity along x of all fluid beside an exact one. */
  static List<Finding> of(SphScheme scheme, double time, double greatest, Exact exact) {
    double[] sums = new double[4]; // fluid particles, velocity, exact velocity, squares
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          if (!scheme.phases().get(phase).solid()) {
            double right = exact.at(y, time);
            sums[0]++;
            sums[1] += u;
            sums[2] += right;
            sums[3] += (u - right) * (u - right);
          }
        });
    double deviation = Math.sqrt(sums[3] / sums[0]);
    return List.of(
        new Finding(
            "velocity_deviation", "velocity, rms error", deviation, 0, deviation / greatest),
        Finding.of("mean_velocity", "mean velocity", sums[1] / sums[0], sums[2] / sums[0]));
  }
}
