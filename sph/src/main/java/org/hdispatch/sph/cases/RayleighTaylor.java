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
 * A heavy fluid, phase 1, over a light one, phase 0, between plane walls, phases 2 and 3: 2-D, one
 * wave along x, to which the interface is bent a little at first, moving as the wave that grows.
 * The layers are as thick as the wave is long. Lengths in spacings, masses in those of a particle
 * of the light fluid.
 *
 * @param across particles along the wave
 * @param densityRatio of the heavy fluid to the light one
 */
public record RayleighTaylor(int across, double densityRatio) {
  private static final double SOUND_SPEED = 10; // of the light fluid
  private static final double VISCOSITY = 0.1; // kinematic, of both
  private static final double COMPRESSION = 0.02; // from the middle to the top or the bottom
  private static final double AMPLITUDE = 0.02; // of the wave
  private static final int LAYERS = ViscousFlow.LAYERS;

  /**
   * Checks size and densities.
   *
   * @throws IllegalArgumentException if the wave is shorter than 12 particles, or the upper fluid
   *     is not the heavier one
   */
  public RayleighTaylor {
    if (across < 12) {
      throw new IllegalArgumentException("wave must be at least 12 particles: across=" + across);
    }
    if (!(densityRatio > 1 && densityRatio <= 100)) {
      throw new IllegalArgumentException(
          "density ratio must lie between 1 and 100: ratio=" + densityRatio);
    }
  }

  /** Acceleration downwards. */
  public double gravity() {
    return COMPRESSION * SOUND_SPEED * SOUND_SPEED / (across * (1 + densityRatio) / 2);
  }

  /** Wave number k. */
  public double waveNumber() {
    return 2 * Math.PI / across;
  }

  /**
   * Rate at which the wave grows at first, sqrt(A g k + nu^2 k^4) - nu k^2, A being the Atwood
   * number (Duff, Harlow, Hirt 1962).
   */
  public double growthRate() {
    double k = waveNumber();
    double atwood = (densityRatio - 1) / (densityRatio + 1);
    double damping = VISCOSITY * k * k;
    return Math.sqrt(atwood * gravity() * k + damping * damping) - damping;
  }

  /** Amplitude of the wave to begin with. */
  public double firstAmplitude() {
    return AMPLITUDE * across;
  }

  /** Settings of the scheme. */
  public SphSchemeBuilder settings() {
    SmoothingKernel kernel = new QuinticSpline(1, 2);
    double rest = LatticeSum.of(kernel, 1).numberDensity();
    double background = 2 * COMPRESSION * SOUND_SPEED * SOUND_SPEED;
    EquationOfState state = EquationOfState.linear(1, SOUND_SPEED, background);
    Phase light = Phase.fluid("light", 1 / rest, VISCOSITY, state);
    Phase heavy =
        Phase.fluid(
            "heavy",
            densityRatio / rest,
            densityRatio * VISCOSITY,
            EquationOfState.beside(state, densityRatio));
    return SphScheme.builder(
            ParticleBox.plane(across, 2 * (across + LAYERS), Ends.PERIODIC, Ends.OPEN), kernel)
        .phase(light)
        .phase(heavy)
        .phase(Phase.wallOf(light))
        .phase(Phase.wallOf(heavy))
        .walls(Walls.slit(LAYERS, LAYERS + 2 * across))
        .bodyForce(0, -gravity(), 0)
        .timeStep(TimeStep.of(kernel, List.of(light, heavy), gravity()).allowed());
  }

  /** The particles: on a lattice, compressed as their weight does, and moved with the wave. */
  public Particles particles() {
    Particles particles = new Particles();
    int low = LAYERS + across; // interface
    int top = LAYERS + 2 * across;
    double k = waveNumber();
    for (int j = 0; j < 2 * (across + LAYERS); j++) {
      for (int i = 0; i < across; i++) {
        double x = i + 0.5;
        double y = j + 0.5;
        if (j < LAYERS) {
          particles.add(2, x, y, 0);
        } else if (j >= top) {
          particles.add(3, x, y, 0);
        } else {
          double height = y - low;
          double settled = height + settling(height) - settling(across);
          double beyond = Math.max(0, k * (across - Math.abs(height)));
          double wave = firstAmplitude() / Math.sinh(k * across);
          double up = wave * Math.cos(k * x) * Math.sinh(beyond);
          double along = wave * Math.sin(k * x) * Math.cosh(beyond) * Math.signum(height);
          particles.add(
              height < 0 ? 0 : 1,
              ((x + along) % across + across) % across,
              low + settled + up,
              0,
              growthRate() * along,
              growthRate() * up,
              0);
        }
      }
    }
    return particles;
  }

  /**
   * How far a particle at a height above the interface sinks where all weigh, seen from the
   * interface: the integral of -P/(c^2 rho0), the mean of P being 0.
   */
  private double settling(double height) {
    double weight = gravity() / (SOUND_SPEED * SOUND_SPEED);
    double density = height > 0 ? densityRatio : 1;
    double interfacial = (densityRatio - 1) * weight * across / 4; // P/(c^2 rho0) there
    return weight * density * height * height / 2 - interfacial * height;
  }

  /** Amplitude of the wave now: its Fourier component, taken over all of the heavy fluid. */
  public double amplitude(SphScheme scheme) {
    double[] sum = new double[1];
    double k = waveNumber();
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> sum[0] += phase == 1 ? Math.cos(k * x) : 0);
    return -2 * sum[0] / across;
  }
}
