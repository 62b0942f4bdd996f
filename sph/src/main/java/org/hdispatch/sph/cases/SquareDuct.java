package org.hdispatch.sph.cases;

import org.hdispatch.cell.Ends;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.ParticleLattice;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.WallDistance;
import org.hdispatch.sph.Walls;

/**
 * Creeping flow through a square duct along x. Side, viscosity, density and body force are 1.
 *
 * @param across particles across the duct
 * @param disorder of the particles to begin with, in spacings: 0 is a lattice
 */
public record SquareDuct(int across, double disorder) implements FlowCase {
  /** Velocity in the middle, over F a^2/nu (White, Viscous Fluid Flow, 3-48). */
  public static final double GREATEST = 0.0736713;

  /** Mean velocity in the duct, over F a^2/nu: its permeability over a^2. */
  public static final double MEAN = 0.0351443;

  private static final int LENGTH = 4; // of the box, in spacings: just no image of an image

  /**
   * Checks the number of particles.
   *
   * @throws IllegalArgumentException if there are fewer than 4
   */
  public SquareDuct {
    Slit.check(across);
  }

  @Override
  public ParticleLattice lattice() {
    double spacing = 1.0 / across;
    double side = (across + 2 * ViscousFlow.LAYERS) * spacing;
    ParticleBox box =
        ParticleBox.space(LENGTH * spacing, side, side, Ends.PERIODIC, Ends.OPEN, Ends.OPEN);
    return new ParticleLattice(box, spacing);
  }

  @Override
  public WallDistance walls() {
    double low = Slit.low(1, across);
    return Walls.duct(low, low + 1, low, low + 1);
  }

  private ViscousFlow flow() {
    double c = ViscousFlow.soundSpeed(GREATEST, 1, 1, 1, 1.0 / across);
    return new ViscousFlow(lattice(), walls(), 1, 1, 1, c);
  }

  @Override
  public SphSchemeBuilder settings() {
    return flow().settings();
  }

  @Override
  public Particles particles() {
    return flow().particles(disorder);
  }
}
