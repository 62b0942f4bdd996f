package org.hdispatch.sph.cases;

import java.util.List;
import org.hdispatch.cell.Ends;
import org.hdispatch.sph.EquationOfState;
import org.hdispatch.sph.LatticeSum;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SmoothingKernel;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.TimeStep;
import org.hdispatch.sph.Walls;

/**
 * Two layers of fluid, phases 0 and 1, side by side between plane walls, phases 2 and 3, in steady
 * flow along x: 2-D. Lengths in spacings, masses in those of a particle of the lower fluid, whose
 * viscosity is 1.
 *
 * @param across particles across each layer
 * @param densityRatio of the upper fluid to the lower one
 * @param viscosityRatio of the dynamic viscosities
 */
public record LayeredPoiseuille(int across, double densityRatio, double viscosityRatio) {
  private static final double FORCE = 1e-4; // per mass
  private static final int LAYERS = ViscousFlow.LAYERS;
  private static final int LENGTH = 10;
  private static final double COMPRESSION = 0.01;

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if a layer is less than 4 particles thick, or a ratio is not
   *     between 0.01 and 100
   */
  public LayeredPoiseuille {
    Slit.check(across);
    checkRatio("density", densityRatio);
    checkRatio("viscosity", viscosityRatio);
  }

  private static void checkRatio(String of, double ratio) {
    if (!(ratio >= 0.01 && ratio <= 100)) {
      throw new IllegalArgumentException(
          "ratio of " + of + " must lie between 0.01 and 100: ratio=" + ratio);
    }
  }

  /** Settings of the scheme. */
  public SphSchemeBuilder settings() {
    SmoothingKernel kernel = new QuinticSpline(1, 2);
    double rest = LatticeSum.of(kernel, 1).numberDensity();
    double heavier = Math.max(1, densityRatio);
    double sound = Math.sqrt(FORCE * heavier * 2 * across / COMPRESSION);
    EquationOfState state = EquationOfState.linear(1, sound, 0);
    Phase lower = Phase.fluid("lower", 1 / rest, 1, state);
    Phase upper =
        Phase.fluid(
            "upper",
            densityRatio / rest,
            viscosityRatio,
            EquationOfState.beside(state, densityRatio));
    return SphScheme.builder(
            ParticleBox.plane(LENGTH, 2 * (across + LAYERS), Ends.PERIODIC, Ends.OPEN), kernel)
        .phase(lower)
        .phase(upper)
        .phase(Phase.wallOf(lower))
        .phase(Phase.wallOf(upper))
        .walls(Walls.slit(LAYERS, LAYERS + 2 * across))
        .bodyForce(FORCE, 0, 0)
        .timeStep(TimeStep.of(kernel, List.of(lower, upper), FORCE).allowed());
  }

  /** The particles, at rest on a lattice. */
  public Particles particles() {
    Particles particles = new Particles();
    for (int j = 0; j < 2 * (across + LAYERS); j++) {
      boolean wall = j < LAYERS || j >= LAYERS + 2 * across;
      int phase = (j < LAYERS + across ? 0 : 1) + (wall ? 2 : 0);
      for (int i = 0; i < LENGTH; i++) {
        particles.add(phase, i + 0.5, j + 0.5, 0);
      }
    }
    return particles;
  }

  /** Time after which the flow differs from the steady one by less than exp(-7). */
  public double settlingTime() {
    double viscosity = Math.min(1, viscosityRatio / densityRatio); // kinematic
    return 7 * 4.0 * across * across / (Math.PI * Math.PI * viscosity);
  }

  /** Velocity of the steady flow at a place along y: two parabolas of one shear stress. */
  public double velocity(double y) {
    double height = y - LAYERS;
    double gap = across;
    // u = a s - F rho s^2/(2 mu), s from the wall; the same velocity and stress in the middle
    double lowerCurve = FORCE / 2;
    double upperCurve = FORCE * densityRatio / (2 * viscosityRatio);
    double stress = FORCE * (1 + densityRatio) * gap; // a of the lower + mu a of the upper
    double upperSlope = (stress + (upperCurve - lowerCurve) * gap) / (1 + viscosityRatio);
    double lowerSlope = stress - viscosityRatio * upperSlope;
    double s = height < gap ? height : 2 * gap - height;
    return height < gap ? lowerSlope * s - lowerCurve * s * s : upperSlope * s - upperCurve * s * s;
  }
}
