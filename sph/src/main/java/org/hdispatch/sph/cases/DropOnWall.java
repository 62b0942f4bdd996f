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
import org.hdispatch.sph.ViscosityMean;

/**
 * A drop, phase 0, in a void on a flat wall, phase 1: 2-D. It begins as the segment of a disc that
 * meets the wall at a given angle, and slides on it. Lengths in spacings, masses in those of a
 * particle, and the surface tension that the strengths are made for is 1.
 *
 * <p>At the smoothing length of other cases, of one spacing, a drop in 2-D is a crystal that keeps
 * the angle that it begins with to 10 to 30 degrees. Here it is 1.5 spacings, forces are those of
 * {@link PairProfile#gaussians}, and the drop flows.
 *
 * @param radius R of a disc of the same area
 * @param contactAngle that the drop takes, in degrees
 * @param firstAngle that the drop begins with, in degrees
 */
public record DropOnWall(double radius, double contactAngle, double firstAngle) {
  private static final double SMOOTHING_LENGTH = 1.5;
  private static final double COMPRESSION = 0.06; // of what cohesion does to the fluid
  private static final double VISCOSITY = 1; // kinematic
  private static final double SLIP = 1e-3; // viscosity at the wall, over that of the fluid
  private static final double DISORDER = 0.1; // spacings
  private static final int SEED = 14;
  private static final double LOSS = 0.335; // of wetting
  private static final int LAYERS = 6; // beyond the support

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if the radius is less than 4 spacings, or an angle is not
   *     between 20 and 160 degrees
   */
  public DropOnWall {
    if (!(radius >= 4 && Double.isFinite(radius))) {
      throw new IllegalArgumentException(
          "radius of a drop must be at least 4 spacings: R=" + radius);
    }
    checkAngle(contactAngle);
    checkAngle(firstAngle);
  }

  private static void checkAngle(double angle) {
    if (!(angle >= 20 && angle <= 160)) {
      throw new IllegalArgumentException(
          "contact angle of a drop must lie between 20 and 160 degrees: angle=" + angle);
    }
  }

  /** Area of the segment of a disc of radius 1 that meets its chord at an angle, in radians. */
  private static double segment(double angle) {
    return angle - Math.sin(angle) * Math.cos(angle);
  }

  private int length() {
    return (int) Math.ceil(7 * radius) + 2 * LAYERS;
  }

  private int height() {
    return (int) Math.ceil(2.5 * radius) + 2 * LAYERS;
  }

  /**
   * Contact angle to ask the mean field for, in degrees. Particles give way at both surfaces, more
   * so where they are attracted less, and the energy of the wetted one is a concave function of the
   * strength: with c, the cosine that the mean field promises, a drop takes that of c - k (1 -
   * c^2). k is measured: drops that c = 1/2, 0 and -1/2 promised 60, 90 and 120 degrees took 73,
   * 110 and 150.
   */
  double meanFieldAngle() {
    double wanted = Math.cos(Math.toRadians(contactAngle));
    double k = LOSS;
    double c = (Math.sqrt(1 + 4 * k * (k + wanted)) - 1) / (2 * k);
    return Math.toDegrees(Math.acos(c));
  }

  /** Settings of the scheme. */
  public SphSchemeBuilder settings() {
    SmoothingKernel kernel = new QuinticSpline(SMOOTHING_LENGTH, 2);
    MeanField field = MeanField.onLattice(kernel, 1, PairProfile.gaussians());
    PairForces pairs = field.drop(1, meanFieldAngle());
    double cohesion = -field.virialPressure(pairs.strength(0, 0));
    double sound = Math.sqrt(cohesion / COMPRESSION);
    Phase fluid =
        Phase.fluid(
            "drop",
            1 / LatticeSum.of(kernel, 1).numberDensity(),
            VISCOSITY,
            EquationOfState.withoutTension(EquationOfState.linear(1, sound, cohesion)));
    Phase wall = new Phase("wall", true, fluid.mass(), SLIP * VISCOSITY, fluid.state());
    return SphScheme.builder(
            ParticleBox.plane(length(), height(), Ends.PERIODIC, Ends.OPEN), kernel)
        .phase(fluid)
        .phase(wall)
        .viscosityMean(ViscosityMean.HARMONIC)
        .walls((x, y, z) -> y - LAYERS)
        .pairForces(pairs)
        .timeStep(TimeStep.of(kernel, List.of(fluid, wall), 0, pairs).allowed());
  }

  /** The particles, at rest near a lattice. */
  public Particles particles() {
    Particles particles = new Particles();
    Random random = new Random(SEED);
    double angle = Math.toRadians(firstAngle);
    double curvature = radius * Math.sqrt(Math.PI / segment(angle));
    double middle = LAYERS - curvature * Math.cos(angle);
    for (int j = 0; j < height(); j++) {
      for (int i = 0; i < length(); i++) {
        double x = i + 0.5;
        double y = j + 0.5;
        if (j < LAYERS) {
          particles.add(1, x, y, 0);
        } else if (Math.hypot(x - length() / 2.0, y - middle) < curvature) {
          particles.add(0, x + shake(random), y + shake(random), 0);
        }
      }
    }
    return particles;
  }

  private static double shake(Random random) {
    return DISORDER * (2 * random.nextDouble() - 1);
  }

  /**
   * Angle at which the drop meets the wall, in degrees: that of the circle that fits the widths of
   * its rows best, the two at the wall and those at the top left out.
   *
   * @param scheme of this case
   */
  public double angle(SphScheme scheme) {
    int[] widths = new int[height()];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> widths[(int) y] += phase == 0 ? 1 : 0);
    int top = height() - 1;
    while (widths[top] == 0) {
      top--;
    }
    // half width^2 + y^2 = 2 b y + (r^2 - b^2): a straight line in y
    int rows = 0;
    double sumY = 0;
    double sumYy = 0;
    double sumS = 0;
    double sumSy = 0;
    for (int j = LAYERS + 2; j < top - 1; j++) {
      double y = j + 0.5 - LAYERS;
      double square = widths[j] * widths[j] / 4.0 + y * y;
      rows++;
      sumY += y;
      sumYy += y * y;
      sumS += square;
      sumSy += square * y;
    }
    double slope = (rows * sumSy - sumY * sumS) / (rows * sumYy - sumY * sumY);
    double centre = slope / 2;
    double r = Math.sqrt((sumS - slope * sumY) / rows + centre * centre);
    return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, -centre / r))));
  }
}
