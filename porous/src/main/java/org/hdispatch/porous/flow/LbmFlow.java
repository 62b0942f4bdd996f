package org.hdispatch.porous.flow;

import java.util.Objects;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.pore.Percolation;
import org.hdispatch.porous.pore.PoreSpace;

/**
 * Steady flow through a pore space by the lattice Boltzmann method with the linear (Stokes)
 * equilibrium: one node a voxel, half-way bounce-back at the walls, driven by a body force.
 *
 * <p>The flow is solved on the clusters that span the box along the flow (6-connected), and stops
 * when the estimated relative error of k is below the tolerance twice running.
 */
public final class LbmFlow {
  private LbmFlow() {}

  /**
   * Computes the steady flow.
   *
   * @param dispatcher whose workers step
   * @param space the pore space of the rock
   * @param options settings
   * @param listener hears of the progress
   * @return the flow; k = 0 without a step if no cluster spans
   * @throws IllegalArgumentException if fluid is nowhere held back by a wall
   * @throws DivergedException if k becomes infinite or not a number
   * @throws IllegalStateException if the dispatcher is running a loop or is closed
   * @throws org.hdispatch.dispatch.KernelException if a worker fails, out of memory say
   * @throws java.util.concurrent.CancellationException if the caller is interrupted or the
   *     dispatcher closed meanwhile
   */
  public static SteadyFlow solve(
      Dispatcher dispatcher, PoreSpace space, FlowOptions options, FlowListener listener) {
    Objects.requireNonNull(listener, "listener");
    Percolation percolation =
        Percolation.along(space, options.axis(), options.sides().ends(), options.inlet().ends());
    if (!percolation.percolates()) {
      return SteadyFlow.none(options, space.porosity(), percolation);
    }
    FlowDomain domain = new FlowDomain(percolation.connected(), options);
    return new SteadyLbmRun(dispatcher, space.porosity(), options, percolation, domain, listener)
        .toSteadyState();
  }

  /**
   * Computes the steady flow with immersed boundaries (Noble, Torczynski 1998): voxels may be solid
   * in part. Fluid flows through all of them that are not wholly solid, in pores that do not span
   * too; percolation goes by those that share a face. Some also flows where two such voxels share
   * an edge or a corner alone, which bounce-back would close. {@link FlowOptions#IMMERSED} says at
   * which settings that is right.
   *
   * @param dispatcher whose workers step
   * @param solid the solid fractions of the rock
   * @param options settings
   * @param listener hears of the progress
   * @return the flow; k = 0 without a step if no cluster spans
   * @throws IllegalArgumentException if fluid is nowhere held back by a wall
   * @throws DivergedException if k becomes infinite or not a number
   * @throws IllegalStateException if the dispatcher is running a loop or is closed
   * @throws org.hdispatch.dispatch.KernelException if a worker fails, out of memory say
   * @throws java.util.concurrent.CancellationException if the caller is interrupted or the
   *     dispatcher closed meanwhile
   */
  public static SteadyFlow solve(
      Dispatcher dispatcher, SolidFractions solid, FlowOptions options, FlowListener listener) {
    Objects.requireNonNull(listener, "listener");
    Percolation percolation =
        Percolation.along(
            solid.below(1), options.axis(), options.sides().ends(), options.inlet().ends());
    if (!percolation.percolates()) {
      return SteadyFlow.none(options, solid.porosity(), percolation);
    }
    FlowDomain domain = new FlowDomain(percolation.connected(), solid, options);
    return new SteadyLbmRun(dispatcher, solid.porosity(), options, percolation, domain, listener)
        .toSteadyState();
  }

  /**
   * Heap that a computation with immersed boundaries needs, in bytes: for each node its
   * populations, a sixth as much for links, and what covers it; for each voxel its fraction, twice,
   * the pore space and the field. For a rock that spans as a whole it lies 0 to 20 % above what is
   * held while stepping and after it; set-up may take more for a moment.
   *
   * @throws IllegalArgumentException if fluid is nowhere held back by a wall
   */
  public static long estimatedBytes(SolidFractions solid, FlowOptions options) {
    FlowDomain domain = new FlowDomain(solid.below(1), solid, options);
    long nodes = domain.rockNodes() + 2 * domain.slabVoxels();
    long coveredNodes = domain.rockNodes() - (domain.voxels() - solid.coveredVoxels());
    long perNode = populationBytes(options) + linkBytes(options) / 3 + Integer.BYTES;
    long perCovered = 2 * Integer.BYTES + 4 * Double.BYTES;
    long perVoxel = 2 * Float.BYTES + 1 + 4 * Float.BYTES;
    return nodes * perNode + coveredNodes * perCovered + domain.voxels() * perVoxel;
  }

  /**
   * Heap that a computation needs, in bytes: the populations, half as much for their links, set-up,
   * pore space and field, and what finding the pressure takes. An estimate from above, for a pore
   * space that spans as a whole.
   *
   * @throws IllegalArgumentException if fluid is nowhere held back by a wall
   */
  public static long estimatedBytes(PoreSpace space, FlowOptions options) {
    long slabs = 2L * new FlowDomain(space, options).slabVoxels();
    long perNode = populationBytes(options) + linkBytes(options);
    long perVoxel = 2 * Integer.BYTES + 2 + 4 * Float.BYTES;
    if (options.approach() == Approach.CORRECTED) {
      perNode += PressureSolver.BYTES_PER_NODE;
      perVoxel += PressureSolver.BYTES_PER_VOXEL;
    }
    return (space.poreVoxels() + slabs) * perNode + (space.voxels() + slabs) * perVoxel;
  }

  private static long populationBytes(FlowOptions options) {
    return (long) options.velocitySet().size() * options.storage().bytes();
  }

  /** Of a node in rock: 4 a velocity. */
  private static long linkBytes(FlowOptions options) {
    return (long) options.velocitySet().size() * Integer.BYTES;
  }
}
