package org.hdispatch.app.particles;

import org.hdispatch.cell.Ends;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.sph.EquationOfState;
import org.hdispatch.sph.LatticeSum;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.ParticleLattice;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.VoxelWalls;
import org.hdispatch.sph.WallDistance;

/**
 * A fluid set in motion along x in rock: a particle in each voxel of a pore, near its middle, and
 * one in each of the solid that lies within the support of the fluid. The rock is continued by its
 * mirror images as often as wanted, and the whole is periodic. Lengths in voxels, times in steps.
 */
final class RockFlow {
  /** Support radius of the quintic spline at h = dx. */
  private static final double SUPPORT = 3;

  private static final double SKIN = 0.3;
  private static final double SOUND_SPEED = 0.15;
  private static final double VISCOSITY = 0.01;

  /** Velocity along x to begin with: that of the fastest in the periodic case. */
  private static final double VELOCITY = 0.015;

  private static final double DISORDER = 0.05;
  private static final int SEED = 20;

  private final ParticleBox box;
  private final WallDistance walls;

  /**
   * A rock and its images.
   *
   * @param repeats rocks along x, y and z, the first one included
   * @throws IllegalArgumentException if an axis has less than 6 voxels in all
   */
  RockFlow(PoreSpace space, int[] repeats) {
    int nx = space.nx() * repeats[0];
    int ny = space.ny() * repeats[1];
    int nz = space.nz() * repeats[2];
    if (Math.min(nx, Math.min(ny, nz)) < 2 * SUPPORT) {
      throw new IllegalArgumentException(
          "rock must have at least 6 voxels along each axis: voxels="
              + nx
              + " x "
              + ny
              + " x "
              + nz);
    }
    box = ParticleBox.space(nx, ny, nz, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
    walls =
        new VoxelWalls(
            nx,
            ny,
            nz,
            1,
            Ends.PERIODIC,
            Ends.PERIODIC,
            Ends.PERIODIC,
            (x, y, z) ->
                !space.isPore(
                    mirrored(x, space.nx()), mirrored(y, space.ny()), mirrored(z, space.nz())));
  }

  private static int mirrored(int place, int length) {
    int in = place % (2 * length);
    return in < length ? in : 2 * length - 1 - in;
  }

  /**
   * As many images as give so many particles, or one; axes grow in turn, x first.
   *
   * @param one particles of the rock alone
   */
  static int[] repeats(int one, long wanted) {
    int[] repeats = {1, 1, 1};
    for (int axis = 0; (long) one * repeats[0] * repeats[1] * repeats[2] < wanted; axis++) {
      repeats[axis % 3]++;
    }
    return repeats;
  }

  /** The particles: fluid all of one velocity, which walls and pressure take from it. */
  Particles particles() {
    Particles resting = new ParticleLattice(box, 1).fill(walls, SUPPORT, DISORDER, SEED);
    Particles particles = new Particles();
    for (int n = 0; n < resting.count(); n++) {
      int phase = resting.phase(n);
      double u = phase == 0 ? VELOCITY : 0;
      particles.add(phase, resting.x(n), resting.y(n), resting.z(n), u, 0, 0);
    }
    return particles;
  }

  /** Settings of the scheme. */
  SphSchemeBuilder settings() {
    QuinticSpline kernel = new QuinticSpline(SUPPORT / 3, 3);
    Phase fluid =
        Phase.fluid(
            "fluid",
            1 / LatticeSum.of(kernel, 1).numberDensity(),
            VISCOSITY,
            EquationOfState.linear(1, SOUND_SPEED, 0));
    return SphScheme.builder(box, kernel)
        .phase(fluid)
        .phase(Phase.wallOf(fluid))
        .walls(walls)
        .skin(SKIN)
        .timeStep(1);
  }
}
