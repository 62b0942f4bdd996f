package org.hdispatch.porous.flow;

import java.util.Objects;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.Percolation;
import org.hdispatch.porous.pore.PoreSpace;

/**
 * Steady flow through a pore space by smoothed particle hydrodynamics: one particle a voxel, frozen
 * particles as walls (Leonardi et al. 2011, section 5), driven by a body force.
 *
 * <p>As the lattice Boltzmann flow, it starts from the pressure that Darcy's law from node to node
 * gives, and that pressure is corrected every few steps; here it acts as an acceleration, beside
 * the pressure of the particles.
 */
public final class SphFlow {
  /** Heap that a particle takes. */
  private static final int BYTES_PER_PARTICLE = 450;

  /** Heap that the neighbours of a particle take, listed, at h = 1; they grow as h^3. */
  private static final int BYTES_PER_LIST = 150;

  private SphFlow() {}

  /**
   * Computes the steady flow.
   *
   * @param dispatcher whose workers step
   * @param space the pore space of the rock
   * @param options axis, boundaries (walled or periodic sides; slabs or periodic ends), tolerance
   *     and limit of steps; the rest is of the lattice Boltzmann method
   * @param particles settings
   * @param listener hears of the progress
   * @return the flow; k = 0 without a step if no cluster spans
   * @throws IllegalArgumentException if the boundaries are others, fluid is nowhere held back by a
   *     wall, or particles reach farther than the rock is long where it is periodic
   * @throws org.hdispatch.dispatch.KernelException if the flow blows up, or a worker fails
   * @throws IllegalStateException if the dispatcher is running a loop or is closed
   * @throws java.util.concurrent.CancellationException if the caller is interrupted or the
   *     dispatcher closed meanwhile
   */
  public static SteadyFlow solve(
      Dispatcher dispatcher,
      PoreSpace space,
      FlowOptions options,
      SphOptions particles,
      FlowListener listener) {
    Objects.requireNonNull(listener, "listener");
    Objects.requireNonNull(particles, "particles");
    check(options);
    Percolation percolation =
        Percolation.along(space, options.axis(), options.sides().ends(), options.inlet().ends());
    if (!percolation.percolates()) {
      return SteadyFlow.none(options, space.porosity(), percolation);
    }
    FlowDomain domain = new FlowDomain(percolation.connected(), options);
    checkLength(domain, particles);
    return new SteadySphRun(
            dispatcher, space.porosity(), options, particles, percolation, domain, listener)
        .toSteadyState();
  }

  /**
   * Checks that particles can compute a flow with these boundaries.
   *
   * @throws IllegalArgumentException if the sides are mirrors or the inlet is of pressure
   */
  public static void check(FlowOptions options) {
    if (options.sides() == Sides.MIRROR || options.inlet() == Inlet.PRESSURE) {
      throw new IllegalArgumentException(
          "boundaries of particles must be walls, slabs or periodic: sides="
              + options.sides()
              + ", inlet="
              + options.inlet());
    }
  }

  /** No particle sees another twice. */
  private static void checkLength(FlowDomain domain, SphOptions particles) {
    double reach = SteadySphRun.reach(particles);
    for (Axis axis : Axis.values()) {
      Lattice lattice = domain.lattice();
      int length = axis.length(lattice.nx(), lattice.ny(), lattice.nz());
      if (!domain.isWalled(axis.ordinal()) && length < reach) {
        throw new IllegalArgumentException(
            "rock must be as long as particles reach where it is periodic: axis="
                + axis
                + ", length="
                + length
                + " voxels, reach="
                + reach
                + " voxels");
      }
    }
  }

  /**
   * Heap that a computation needs, in bytes: an estimate from above, for a rock of which every
   * voxel is a particle.
   *
   * @throws IllegalArgumentException if the boundaries or lengths are not those of {@link #solve}
   */
  public static long estimatedBytes(PoreSpace space, FlowOptions options, SphOptions particles) {
    check(options);
    FlowDomain domain = new FlowDomain(space, options);
    checkLength(domain, particles);
    double h = particles.smoothingLength();
    double each = BYTES_PER_PARTICLE + BYTES_PER_LIST * h * h * h;
    double all = each * ParticleLayout.voxels(domain, SteadySphRun.reach(particles));
    long nodes = space.voxels() + 2 * domain.slabVoxels();
    return (long) all
        + nodes * (PressureSolver.BYTES_PER_VOXEL + 4 * Double.BYTES)
        + (space.poreVoxels() + 2 * domain.slabVoxels()) * PressureSolver.BYTES_PER_NODE;
  }
}
