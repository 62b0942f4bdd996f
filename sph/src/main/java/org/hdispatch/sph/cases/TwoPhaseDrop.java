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
 * A drop, phase 0, in another fluid, phase 1: 2-D, periodic box. Lengths in spacings, masses in
 * those of a particle outside, kinematic viscosities equal.
 *
 * @param radius R of the drop
 * @param densityRatio of the drop to the fluid around it
 * @param surfaceTension that the strengths are made for; 0: no pairwise forces
 * @param disorder how far from a lattice particles may begin, in spacings along each axis
 */
public record TwoPhaseDrop(
    double radius, double densityRatio, double surfaceTension, double disorder) {
  private static final double SOUND_SPEED = 6; // of the fluid outside
  private static final double VISCOSITY = 1; // kinematic
  private static final double BACKGROUND = 0.06; // pressure, over that of sound
  private static final int SEED = 13;

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if the radius is less than 4 spacings, the density ratio is
   *     not between 0.01 and 100, the surface tension not between 0 and 1, or the disorder not
   *     between 0 and 1/2
   */
  public TwoPhaseDrop {
    if (!(radius >= 4 && Double.isFinite(radius))) {
      throw new IllegalArgumentException(
          "radius of a drop must be at least 4 spacings: R=" + radius);
    }
    if (!(densityRatio >= 0.01 && densityRatio <= 100)) {
      throw new IllegalArgumentException(
          "ratio of density must lie between 0.01 and 100: ratio=" + densityRatio);
    }
    if (!(surfaceTension >= 0 && surfaceTension <= 1)) {
      throw new IllegalArgumentException(
          "surface tension must lie between 0 and 1: sigma=" + surfaceTension);
    }
    if (!(disorder >= 0 && disorder <= 0.5)) {
      throw new IllegalArgumentException(
          "disorder must be 0 to 0.5 spacings of the lattice: disorder=" + disorder);
    }
  }

  /** Edge of the box. */
  public int edge() {
    return 2 * (int) Math.ceil(1.6 * radius + 4);
  }

  /** Speed of sound outside the drop. */
  public double soundSpeed() {
    return SOUND_SPEED;
  }

  /** Settings of the scheme. */
  public SphSchemeBuilder settings() {
    SmoothingKernel kernel = new QuinticSpline(1, 2);
    double rest = LatticeSum.of(kernel, 1).numberDensity();
    EquationOfState outside =
        EquationOfState.linear(1, SOUND_SPEED, BACKGROUND * SOUND_SPEED * SOUND_SPEED);
    EquationOfState inside = EquationOfState.beside(outside, densityRatio);
    Phase drop = Phase.fluid("drop", densityRatio / rest, densityRatio * VISCOSITY, inside);
    Phase around = Phase.fluid("around", 1 / rest, VISCOSITY, outside);
    SphSchemeBuilder settings =
        SphScheme.builder(ParticleBox.plane(edge(), edge(), Ends.PERIODIC, Ends.PERIODIC), kernel)
            .phase(drop)
            .phase(around);
    if (surfaceTension == 0) {
      return settings.timeStep(TimeStep.of(kernel, List.of(drop, around), 0).allowed());
    }
    PairForces pairs =
        MeanField.onLattice(kernel, 1, PairProfile.cosine()).twoFluids(surfaceTension);
    return settings
        .pairForces(pairs)
        .timeStep(TimeStep.of(kernel, List.of(drop, around), 0, pairs).allowed());
  }

  /** The particles, at rest. */
  public Particles particles() {
    Particles particles = new Particles();
    Random random = new Random(SEED);
    double middle = edge() / 2.0;
    for (int j = 0; j < edge(); j++) {
      for (int i = 0; i < edge(); i++) {
        double x = i + 0.5;
        double y = j + 0.5;
        int phase = Math.hypot(x - middle, y - middle) < radius ? 0 : 1;
        particles.add(phase, x + shake(random), y + shake(random), 0);
      }
    }
    return particles;
  }

  private double shake(Random random) {
    return disorder * (2 * random.nextDouble() - 1);
  }
}
