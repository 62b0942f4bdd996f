package org.hdispatch.sph;

import java.util.List;
import java.util.Objects;

/**
 * What pairwise forces amount to where particles are spread evenly on either side of a sharp
 * surface (Kirkwood, Buff 1949; Fowler 1937), and which strengths make a surface tension. With M_k,
 * the integral of q^k f over q from 0 to 1, and D = s_aa + s_bb - 2 s_ab:
 *
 * <pre>
 *                       2-D                          3-D
 * surface tension      -(1/3) n^2 H^4 M_3 D          -(pi/8) n^2 H^5 M_4 D
 * virial pressure       (pi/2) n^2 H^3 M_2 s_aa       (2 pi/3) n^2 H^4 M_3 s_aa
 * </pre>
 *
 * <p>For the cosine: 0.04757 and 0.04236; -0.3033 and -0.2989. The contact angle is Young's,
 *
 * <pre>
 * cos(angle) = (s_bb - s_aa + 2 (s_sa - s_sb))/D
 * </pre>
 *
 * <p>measured in a, with solid particles as dense as fluid ones. A fluid b that there is none of, a
 * void, has strengths of 0.
 *
 * @param kernel its support radius is H
 * @param numberDensity n of all phases at rest
 * @param profile f
 */
public record MeanField(SmoothingKernel kernel, double numberDensity, PairProfile profile) {

  /**
   * Checks the density.
   *
   * @throws IllegalArgumentException if n is not positive
   */
  public MeanField {
    Checks.positive("number density", "n", numberDensity);
    Objects.requireNonNull(kernel, "kernel");
    Objects.requireNonNull(profile, "profile");
  }

  /** The field of particles on a lattice. */
  public static MeanField onLattice(SmoothingKernel kernel, double spacing, PairProfile profile) {
    return new MeanField(kernel, Math.pow(spacing, -kernel.dimensions()), profile);
  }

  private double tensionFactor() {
    int d = kernel.dimensions();
    double n = numberDensity;
    double angles = d == 2 ? 1.0 / 3 : Math.PI / 8;
    return -angles * n * n * Math.pow(kernel.supportRadius(), d + 2) * profile.moment(d + 1);
  }

  /** Surface tension between two fluids; for one in a void the other strengths are 0. */
  public double surfaceTension(double saa, double sbb, double sab) {
    return tensionFactor() * (saa + sbb - 2 * sab);
  }

  /** Pressure that the forces within a fluid add; negative for those that attract. */
  public double virialPressure(double saa) {
    int d = kernel.dimensions();
    double n = numberDensity;
    double angles = d == 2 ? Math.PI / 2 : 2 * Math.PI / 3;
    return angles * n * n * Math.pow(kernel.supportRadius(), d + 1) * profile.moment(d) * saa;
  }

  /** Size of the force on a particle at the plane surface of a half-space of others. */
  static double surfaceForce(
      SmoothingKernel kernel, Phase others, PairProfile profile, double strength) {
    int d = kernel.dimensions();
    double angles = d == 2 ? 2 : Math.PI;
    double reach = Math.pow(kernel.supportRadius(), d);
    double n = of(kernel, others, profile).numberDensity;
    return angles * n * reach * Math.abs(profile.moment(d - 1) * strength);
  }

  /** Greatest surface tension of any two of the fluids, or of one in a void; 0 if all repel. */
  static double greatestTension(SmoothingKernel kernel, List<Phase> phases, PairForces pairs) {
    double most = 0;
    for (int a = 0; a < phases.size(); a++) {
      if (phases.get(a).solid()) {
        continue;
      }
      MeanField field = of(kernel, phases.get(a), pairs.profile());
      double saa = pairs.strength(a, a);
      most = Math.max(most, field.surfaceTension(saa, 0, 0));
      for (int b = 0; b < a; b++) {
        if (!phases.get(b).solid()) {
          double sbb = pairs.strength(b, b);
          most = Math.max(most, field.surfaceTension(saa, sbb, pairs.strength(a, b)));
        }
      }
    }
    return most;
  }

  private static MeanField of(SmoothingKernel kernel, Phase phase, PairProfile profile) {
    return new MeanField(kernel, phase.state().restDensity() / phase.mass(), profile);
  }

  /**
   * One fluid in a void: phase 0.
   *
   * @throws IllegalArgumentException if the surface tension is not positive, or the profile does
   *     not make surfaces contract
   */
  public PairForces drop(double surfaceTension) {
    return new PairForces(profile, new double[][] {{strength(surfaceTension)}});
  }

  /**
   * One fluid in a void, phase 0, and a wall, phase 1.
   *
   * @param contactAngle in degrees
   * @throws IllegalArgumentException if the surface tension is not positive, or the angle is not
   *     between 0 and 180 degrees
   */
  public PairForces drop(double surfaceTension, double contactAngle) {
    double s = strength(surfaceTension);
    double wall = s * (1 + cosine(contactAngle)) / 2;
    return new PairForces(profile, new double[][] {{s, wall}, {wall, 0}});
  }

  /** Two fluids, phases 0 and 1: unlike particles exert no force on each other. */
  public PairForces twoFluids(double surfaceTension) {
    double s = strength(surfaceTension) / 2;
    return new PairForces(profile, new double[][] {{s, 0}, {0, s}});
  }

  /**
   * Two fluids, phases 0 and 1, and a wall, phase 2.
   *
   * @param contactAngle in degrees, measured in phase 0
   * @throws IllegalArgumentException if the surface tension is not positive, or the angle is not
   *     between 0 and 180 degrees
   */
  public PairForces twoFluids(double surfaceTension, double contactAngle) {
    double s = strength(surfaceTension) / 2;
    double cosine = cosine(contactAngle);
    double first = s * (1 + cosine) / 2;
    double second = s * (1 - cosine) / 2;
    return new PairForces(
        profile, new double[][] {{s, 0, first}, {0, s, second}, {first, second, 0}});
  }

  private double strength(double surfaceTension) {
    Checks.positive("surface tension", "sigma", surfaceTension);
    if (!(tensionFactor() > 0)) {
      throw new IllegalArgumentException(
          "profile must attract at a distance: profile="
              + profile
              + ", moment="
              + profile.moment(kernel.dimensions() + 1));
    }
    return surfaceTension / tensionFactor();
  }

  private static double cosine(double contactAngle) {
    if (!(contactAngle >= 0 && contactAngle <= 180)) {
      throw new IllegalArgumentException(
          "contact angle must lie between 0 and 180 degrees: angle=" + contactAngle);
    }
    return Math.cos(Math.toRadians(contactAngle));
  }
}
