package org.hdispatch.sph.cases;

import java.util.List;
import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.sph.EquationOfState;
import org.hdispatch.sph.LatticeSum;
import org.hdispatch.sph.MeanField;
import org.hdispatch.sph.PairForces;
import org.hdispatch.sph.PairProfile;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SmoothingKernel;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.TimeStep;

/**
 * A drop of one fluid in a void, held together by pairwise forces: a disc in 2-D, a ball in 3-D.
 * Lengths in spacings, masses in those of a particle, and the surface tension that the strengths
 * are made for is 1.
 *
 * @param dimensions 2 or 3
 * @param radius R of the drop at rest
 * @param viscosity kinematic; 1 calms a drop within a few times R^2
 * @param stretch length over width to begin with: 1 is round
 * @param smoothingLength h of the quintic spline
 * @param profile of the pairwise forces
 */
public record Drop(
    int dimensions,
    double radius,
    double viscosity,
    double stretch,
    double smoothingLength,
    PairProfile profile) {
  private static final double COMPRESSION = 0.06; // of what cohesion does to the fluid
  private static final double DISORDER = 0.1; // spacings
  private static final double INSIDE = 0.6; // of the radius: far from the surface
  private static final int SEED = 12;

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if the radius is less than 4 spacings, the viscosity is not
   *     positive, or the stretch does not lie between 1/4 and 4
   */
  public Drop {
    if (!(radius >= 4 && Double.isFinite(radius))) {
      throw new IllegalArgumentException(
          "radius of a drop must be at least 4 spacings: R=" + radius);
    }
    if (!(viscosity > 0 && Double.isFinite(viscosity))) {
      throw new IllegalArgumentException(
          "viscosity of a drop must be positive and finite: nu=" + viscosity);
    }
    if (!(stretch >= 0.25 && stretch <= 4)) {
      throw new IllegalArgumentException(
          "stretch of a drop must lie between 1/4 and 4: stretch=" + stretch);
    }
  }

  /**
   * A drop for pressures at rest: cosine, h = 1. In 2-D it is a crystal, which yields to surface
   * tension where it must but does not flow.
   */
  public static Drop firm(int dimensions, double radius) {
    return new Drop(dimensions, radius, 1, 1, 1, PairProfile.cosine());
  }

  /** A drop that flows like a liquid: {@link PairProfile#gaussians}, h = 1.5. */
  public static Drop liquid(int dimensions, double radius, double viscosity, double stretch) {
    return new Drop(dimensions, radius, viscosity, stretch, 1.5, PairProfile.gaussians());
  }

  private SmoothingKernel kernel() {
    return new QuinticSpline(smoothingLength, dimensions);
  }

  private MeanField field() {
    return MeanField.onLattice(kernel(), 1, profile);
  }

  private double edge() {
    return Math.ceil(2 * radius * Math.max(stretch, 1 / stretch)) + 12;
  }

  /** Pressure by which pairwise forces hold the fluid together, and which it is given at rest. */
  public double cohesion() {
    return -field().virialPressure(field().drop(1).strength(0, 0));
  }

  /** Period of the oscillation between long and flat (Rayleigh 1879), of this surface tension. */
  public double period(double surfaceTension) {
    double cube = radius * radius * radius;
    return 2 * Math.PI * Math.sqrt(cube / ((dimensions == 2 ? 6 : 8) * surfaceTension));
  }

  /** Pressure inside a resting drop of so many particles by Laplace's law: (D - 1)/R. */
  public double laplacePressure(int particles) {
    return (dimensions - 1) / radius(particles);
  }

  /** Radius of a drop of so many particles, of which there is one in a unit of volume. */
  private double radius(int particles) {
    return dimensions == 2
        ? Math.sqrt(particles / Math.PI)
        : Math.cbrt(3.0 * particles / (4 * Math.PI));
  }

  /**
   * Mean pressure inside the drop, up to 0.6 R from its middle.
   *
   * @param scheme of this case, after a step
   */
  public double pressure(SphScheme scheme) {
    int count = scheme.particles();
    double inside = INSIDE * radius(count);
    double[] sums = new double[5]; // x, y, z of the middle; pressure, particles inside
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          sums[0] += x / count;
          sums[1] += y / count;
          sums[2] += z / count;
        });
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          double dx = x - sums[0];
          double dy = y - sums[1];
          double dz = z - sums[2];
          if (dx * dx + dy * dy + dz * dz < inside * inside) {
            sums[3] += p;
            sums[4]++;
          }
        });
    return sums[3] / sums[4];
  }

  /** Settings of the scheme. */
  public SphSchemeBuilder settings() {
    SmoothingKernel kernel = kernel();
    PairForces pairs = field().drop(1);
    double sound = Math.sqrt(cohesion() / COMPRESSION);
    Phase fluid =
        Phase.fluid(
            "drop",
            1 / LatticeSum.of(kernel, 1).numberDensity(),
            viscosity,
            EquationOfState.withoutTension(EquationOfState.linear(1, sound, cohesion())));
    double edge = edge();
    ParticleBox box =
        dimensions == 2
            ? ParticleBox.plane(edge, edge, Ends.OPEN, Ends.OPEN)
            : ParticleBox.space(edge, edge, edge, Ends.OPEN, Ends.OPEN, Ends.OPEN);
    return SphScheme.builder(box, kernel)
        .phase(fluid)
        .pairForces(pairs)
        .timeStep(TimeStep.of(kernel, List.of(fluid), 0, pairs).allowed());
  }

  /** The particles, at rest near a lattice. */
  public Particles particles() {
    Particles particles = new Particles();
    Random random = new Random(SEED);
    int edge = (int) edge();
    double middle = edge / 2.0;
    double longAxis = Math.pow(stretch, (dimensions - 1.0) / dimensions);
    double shortAxis = longAxis / stretch;
    for (int k = 0; k < (dimensions == 2 ? 1 : edge); k++) {
      for (int j = 0; j < edge; j++) {
        for (int i = 0; i < edge; i++) {
          double x = (i + 0.5 - middle) / longAxis;
          double y = (j + 0.5 - middle) / shortAxis;
          double z = dimensions == 2 ? 0 : (k + 0.5 - middle) / shortAxis;
          if (x * x + y * y + z * z < radius * radius) {
            particles.add(
                0,
                i + 0.5 + shake(random),
                j + 0.5 + shake(random),
                dimensions == 2 ? 0 : k + 0.5 + shake(random));
          }
        }
      }
    }
    return particles;
  }

  private static double shake(Random random) {
    return DISORDER * (2 * random.nextDouble() - 1);
  }
}
