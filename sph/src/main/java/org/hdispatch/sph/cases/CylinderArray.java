package org.hdispatch.sph.cases;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hdispatch.cell.Ends;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.ParticleLattice;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.WallDistance;
import org.hdispatch.sph.Walls;

/**
 * Flow through a square array of cylinders, along a row of them: one periodic cell in 2-D, the
 * cylinder in its middle.
 *
 * @param length L, edge of the cell
 * @param radius of the cylinder, less than L/2
 * @param viscosity nu, kinematic
 * @param force F, body force per mass
 * @param soundSpeed c
 * @param across particles along the edge
 * @param disorder of the particles to begin with, in spacings: 0 is a lattice
 */
public record CylinderArray(
    double length,
    double radius,
    double viscosity,
    double force,
    double soundSpeed,
    int across,
    double disorder)
    implements FlowCase {
  private static final double TOUCHING = Math.PI / 4;

  // Sangani, Acrivos 1982, Table 1: solid fraction, F/(mu U)
  private static final double[] FRACTIONS = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  private static final double[] DRAGS = {15.56, 24.83, 51.53, 102.90, 217.89, 532.55, 1763, 13520};

  /** The drags times what grows beyond all bounds as cylinders touch, which leaves 7 to 10. */
  private static final DragTable TABLE =
      new DragTable(
          Arrays.stream(FRACTIONS).map(Math::sqrt).toArray(),
          IntStream.range(0, DRAGS.length)
              .mapToDouble(n -> DRAGS[n] * lubrication(FRACTIONS[n]))
              .toArray());

  /**
   * Checks the radius and the number of particles.
   *
   * @throws IllegalArgumentException if cylinders touch, or there are fewer than 8 particles
   */
  public CylinderArray {
    if (!(radius < length / 2)) {
      throw new IllegalArgumentException(
          "cylinders must not touch: radius=" + radius + ", length=" + length);
    }
    SimpleCubicSpheres.check(across);
  }

  /** The cell of Morris, Fox, Zhu (1997) at Re 1: lengths in m, times in s. */
  public static CylinderArray morrisAtRe1(int across) {
    return new CylinderArray(0.1, 0.02, 1e-6, 1.5e-7, 5.77e-4, across, 0);
  }

  /**
   * The same at Re 0.03. Sound is faster than the paper's 0.01 m/s, by Morris' criteria for a
   * change of density of 1 %, which costs nothing: viscosity limits the time step.
   */
  public static CylinderArray morrisAtRe003(int across) {
    double length = 0.1;
    double c = ViscousFlow.soundSpeed(4e-4, 1e-4, length, 5e-5, length / across);
    return new CylinderArray(length, 0.02, 1e-4, 5e-5, c, across, 0);
  }

  /** Creeping flow in a cell whose edge, viscosity and body force are 1. */
  public static CylinderArray ofSolidFraction(double fraction, int across, double disorder) {
    double radius = Math.sqrt(fraction / Math.PI);
    double velocity = 2 / drag(fraction); // of the fastest
    double c = ViscousFlow.soundSpeed(velocity, 1, 1, 1, 1.0 / across);
    return new CylinderArray(1, radius, 1, 1, c, across, disorder);
  }

  private static double lubrication(double fraction) {
    return Math.pow(1 - Math.sqrt(fraction / TOUCHING), 2.5);
  }

  /**
   * Drag on a cylinder in creeping flow over mu U, U being the superficial velocity: L^2 over the
   * permeability (Sangani, Acrivos 1982, Table 1; between its entries by interpolation of what
   * their eq. for touching cylinders leaves).
   *
   * @param fraction solid fraction, 0.05 to 0.75
   */
  public static double drag(double fraction) {
    return TABLE.at(Math.sqrt(fraction)) / lubrication(fraction);
  }

  @Override
  public ParticleLattice lattice() {
    ParticleBox box = ParticleBox.plane(length, length, Ends.PERIODIC, Ends.PERIODIC);
    return new ParticleLattice(box, length / across);
  }

  @Override
  public WallDistance walls() {
    return Walls.cylinders(
        lattice().box(), List.of(new Walls.Cylinder(length / 2, length / 2, radius)));
  }

  private ViscousFlow flow() {
    return new ViscousFlow(lattice(), walls(), 1000, viscosity, force, soundSpeed);
  }

  @Override
  public SphSchemeBuilder settings() {
    return flow().settings();
  }

  @Override
  public Particles particles() {
    return flow().particles(disorder);
  }

  /** Superficial velocity of the steady creeping flow around the particles of the solid. */
  public double superficialVelocity() {
    return force * length * length / (viscosity * drag(1 - lattice().porosity(walls())));
  }
}
