package org.hdispatch.sph.cases;

import org.hdispatch.sph.ParticleLattice;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.WallDistance;

/** A flow along x of one fluid, phase 0, between walls, phase 1. */
public interface FlowCase {
  /** The lattice that particles begin on or near. */
  ParticleLattice lattice();

  /** Where the walls are. */
  WallDistance walls();

  /** Settings of the scheme, each of which may still be changed. */
  SphSchemeBuilder settings();

  /** The particles to begin with. */
  Particles particles();

  /** The scheme as it is set. */
  default SphScheme scheme() {
    return settings().build(particles());
  }

  /**
   * Mean velocity of the fluid along x over the whole box, walls included: the superficial one.
   *
   * @param scheme of this case
   */
  default double superficialVelocity(SphScheme scheme) {
    double[] sum = new double[1];
    scheme.forEachParticle((id, phase, x, y, z, u, v, w, n, p) -> sum[0] += phase == 0 ? u : 0);
    ParticleLattice sites = lattice();
    return sum[0] / ((double) sites.nx() * sites.ny() * sites.nz());
  }
}
