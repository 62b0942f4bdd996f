package org.hdispatch.app.particles;

import java.util.List;
import java.util.function.DoubleSupplier;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.cases.FlowCase;

/**
 * A flow along x whose steady superficial velocity is known.
 *
 * @param flow the flow
 * @param duration time after which it is steady
 * @param known the superficial velocity that is right; asked for at the end, as it takes a look at
 *     every site
 */
record MeanFlow(FlowCase flow, double duration, DoubleSupplier known) implements ReadyFlow {
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
    double found = flow.superficialVelocity(scheme);
    return List.of(
        Finding.of("superficial_velocity", "superficial velocity", found, known.getAsDouble()));
  }
}
