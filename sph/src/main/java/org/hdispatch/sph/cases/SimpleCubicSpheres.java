package org.hdispatch.sph.cases;

import java.util.Arrays;
import java.util.List;
import org.hdispatch.cell.Ends;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.ParticleLattice;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.WallDistance;
import org.hdispatch.sph.Walls;

/**
 * Creeping flow through a simple-cubic array of spheres: one periodic cell, the sphere in its
 * middle. Edge of the cell, viscosity, density and body force are 1.
 *
 * @param fraction solid fraction, pi/6 at most
 * @param across particles along the edge
 * @param disorder of the particles to begin with, in spacings: 0 is a lattice
 */
public record SimpleCubicSpheres(double fraction, int across, double disorder) implements FlowCase {
  /** Solid fraction of spheres that touch. */
  public static final double TOUCHING = Math.PI / 6;

  private static final int LEAST_ACROSS = 8;

  // Zick, Homsy 1982, Table 2: solid fraction, K
  private static final double[] FRACTIONS = {0.027, 0.064, 0.125, 0.216, 0.343, 0.45, TOUCHING};
  private static final double[] DRAGS = {2.008, 2.810, 4.292, 7.442, 15.4, 28.1, 42.1};
  private static final DragTable TABLE =
      new DragTable(
          Arrays.stream(FRACTIONS).map(Math::cbrt).toArray(),
          Arrays.stream(DRAGS).map(Math::log).toArray());

  /**
   * Checks the solid fraction and the number of particles.
   *
   * @throws IllegalArgumentException if spheres overlap, or there are fewer than 8 particles
   */
  public SimpleCubicSpheres {
    if (!(fraction > 0 && fraction <= TOUCHING)) {
      throw new IllegalArgumentException(
          "spheres must not overlap: fraction=" + fraction + ", most=" + TOUCHING);
    }
    check(across);
  }

  static void check(int across) {
    if (across < LEAST_ACROSS) {
      throw new IllegalArgumentException(
          "there must be at least " + LEAST_ACROSS + " particles along the cell: across=" + across);
    }
  }

  /**
   * Drag on a sphere over Stokes': K = D/(6 pi mu a U), U being the superficial velocity (Zick,
   * Homsy 1982, Table 2; between its entries by interpolation of ln K over the cube root of the
   * solid fraction).
   *
   * @param fraction solid fraction, 0.027 to pi/6
   */
  public static double drag(double fraction) {
    return Math.exp(TABLE.at(Math.cbrt(fraction)));
  }

  /** Permeability over the square of the cell's edge, 1/(6 pi (a/L) K). */
  public static double permeability(double fraction) {
    return 1 / (6 * Math.PI * Math.cbrt(3 * fraction / (4 * Math.PI)) * drag(fraction));
  }

  @Override
  public ParticleLattice lattice() {
    ParticleBox box = ParticleBox.space(1, 1, 1, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
    return new ParticleLattice(box, 1.0 / across);
  }

  @Override
  public WallDistance walls() {
    double radius = Math.cbrt(3 * fraction / (4 * Math.PI));
    return Walls.spheres(lattice().box(), List.of(new Walls.Sphere(0.5, 0.5, 0.5, radius)));
  }

  private ViscousFlow flow() {
    double velocity = 2 * permeability(fraction); // of the fastest
    double c = ViscousFlow.soundSpeed(velocity, 1, 1, 1, 1.0 / across);
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

  /** Superficial velocity of the steady flow around the particles of the solid. */
  public double superficialVelocity() {
    return permeability(1 - lattice().porosity(walls()));
  }
}
