package org.hdispatch.sph.cases;

import java.util.List;
import org.hdispatch.sph.EquationOfState;
import org.hdispatch.sph.LatticeSum;
import org.hdispatch.sph.ParticleLattice;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SmoothingKernel;
import org.hdispatch.sph.SoundSpeed;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.TimeStep;
import org.hdispatch.sph.WallDistance;

/** What the cases have in common: one fluid between walls, quintic spline, h = dx. */
record ViscousFlow(
    ParticleLattice lattice,
    WallDistance walls,
    double density,
    double viscosity, // kinematic
    double force, // along x, per mass
    double soundSpeed) {
  private static final double DENSITY_CHANGE = 0.01;
  private static final int SEED = 1997;
  private static final int SUPPORT = 3; // dx

  /** Layers of solid that particles of the fluid reach, and the skin. */
  static final int LAYERS = SUPPORT + 1;

  /**
   * Speed of sound of a creeping flow: by Morris' criteria, or as fast as costs nothing, the time
   * step being that of viscosity (half of 2 nu/h, where the two limits meet), so that pressure is
   * even long before the flow is.
   */
  static double soundSpeed(
      double velocity, double viscosity, double length, double force, double spacing) {
    double needed = SoundSpeed.of(velocity, viscosity, length, force, DENSITY_CHANGE).needed();
    return Math.max(needed, viscosity / spacing);
  }

  SphSchemeBuilder settings() {
    SmoothingKernel kernel = new QuinticSpline(lattice.spacing(), lattice.box().dimensions());
    double rest = LatticeSum.of(kernel, lattice.spacing()).numberDensity();
    Phase fluid =
        Phase.fluid(
            "fluid",
            density / rest,
            density * viscosity,
            EquationOfState.linear(density, soundSpeed, 0));
    Phase wall = Phase.wallOf(fluid);
    return SphScheme.builder(lattice.box(), kernel)
        .phase(fluid)
        .phase(wall)
        .walls(walls)
        .bodyForce(force, 0, 0)
        .timeStep(TimeStep.of(kernel, List.of(fluid, wall), force).allowed());
  }

  Particles particles(double disorder) {
    return lattice.fill(walls, LAYERS * lattice.spacing(), disorder, SEED);
  }
}
