package org.hdispatch.app.particles;

import java.util.List;
import java.util.function.Supplier;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;

/** A flow whose particles lie at a distance of 1: lengths are in it. */
final class LatticeFlow implements ReadyFlow {
  private final Supplier<SphSchemeBuilder> settings;
  private final Supplier<Particles> particles;
  private final double duration;
  private final Finder finder;

  /** Finds what is known. */
  interface Finder {
    /** As {@link ReadyFlow#findings}. */
    List<Finding> find(SphScheme scheme, double time);
  }

  LatticeFlow(
      Supplier<SphSchemeBuilder> settings,
      Supplier<Particles> particles,
      double duration,
      Finder finder) {
    this.settings = settings;
    this.particles = particles;
    this.duration = duration;
    this.finder = finder;
  }

  @Override
  public SphSchemeBuilder settings() {
    return settings.get();
  }

  @Override
  public Particles particles() {
    return particles.get();
  }

  @Override
  public double spacing() {
    return 1;
  }

  @Override
  public double duration() {
    return duration;
  }

  @Override
  public List<Finding> findings(SphScheme scheme, double time) {
    return finder.find(scheme, time);
  }
}
