package org.hdispatch.porous.flow;

import java.util.List;
import java.util.Optional;
import org.hdispatch.dispatch.LoopStats;
import org.hdispatch.porous.darcy.PermeabilityColumn;
import org.hdispatch.porous.pore.Percolation;
import org.hdispatch.porous.pore.PoreSpace;

/**
 * The outcome of a flow computation, in voxel units.
 *
 * @param options what was asked
 * @param porosity pore volume over that of the rock box
 * @param connectedPorosity pore volume of the spanning clusters over that of the rock box
 * @param percolation which part of the pore space spans; the flow was solved in that part
 * @param permeability k, voxel²; 0 if nothing spans
 * @param column what flows in all three directions, as a column of the permeability tensor, whose
 *     entry along the flow is k; empty if the sides are not periodic, where nothing can flow across
 * @param errorEstimate estimated relative error of k; 0 if nothing spans
 * @param changeAtStop relative change of k over the last interval between measurements
 * @param fluxImbalance how far the flux through a section of the rock is at most from the mean,
 *     relative to it; 0 if nothing spans
 * @param converged whether the estimate came below the tolerance; true if nothing spans
 * @param mach highest speed over the speed of sound; 0 if nothing spans
 * @param chosen what was chosen from the pore space
 * @param work what it took
 * @param corrections of the pressure; empty with {@link Approach#PLAIN}, or if nothing spans
 * @param particles of smoothed particle hydrodynamics; empty with the lattice Boltzmann method, or
 *     if nothing spans
 * @param field velocity and pressure; empty if nothing spans
 */
public record SteadyFlow(
    FlowOptions options,
    double porosity,
    double connectedPorosity,
    Percolation percolation,
    double permeability,
    Optional<PermeabilityColumn> column,
    double errorEstimate,
    double changeAtStop,
    double fluxImbalance,
    boolean converged,
    double mach,
    Chosen chosen,
    Work work,
    Optional<Corrections> corrections,
    Optional<ParticleFigures> particles,
    Optional<FlowField> field) {

  /**
   * What was chosen from the pore space, or given.
   *
   * @param hydraulicDiameter 4 volume / surface of the connected pores, the surface being two
   *     thirds of the voxel faces, voxels; NaN if nothing spans
   * @param relaxationTime tau; NaN if nothing spans
   * @param inletLayers layers of fluid at each end; 0 if the inlet has none or nothing spans
   */
  public record Chosen(double hydraulicDiameter, double relaxationTime, int inletLayers) {}

  /**
   * What a computation took.
   *
   * @param fluidNodes fluid nodes of the lattice, slabs included
   * @param steps steps done
   * @param secondsStepping wall time of all steps, warm-up included, s
   * @param warmUpSteps steps before {@code stats}
   * @param stats what the workers did after warm-up
   */
  public record Work(
      long fluidNodes, long steps, double secondsStepping, long warmUpSteps, LoopStats stats) {

    /** Million fluid-node updates per second, warm-up included; 0 if nothing was stepped. */
    public double mflups() {
      return secondsStepping == 0 ? 0 : fluidNodes * (double) steps / secondsStepping * 1e-6;
    }
  }

  /**
   * How the pressure was found.
   *
   * @param count corrections after the start
   * @param helpful whether they helped; if not, they were given up
   * @param seconds wall time of all that has to do with pressure: setting up, start, corrections, s
   */
  public record Corrections(int count, boolean helpful, double seconds) {}

  /**
   * What a computation by particles looked like.
   *
   * @param count all particles, solid ones included
   * @param smoothingLength h, voxels; the distance of particles is 1
   * @param timeStep viscosity times the time step, voxel²
   * @param limit what ruled the time step
   * @param leastCompression least density over rest density
   * @param mostCompression greatest density over rest density
   * @param searches how often neighbours were listed anew
   */
  public record ParticleFigures(
      int count,
      double smoothingLength,
      double timeStep,
      String limit,
      double leastCompression,
      double mostCompression,
      long searches) {}

  /** The outcome where no cluster spans: k = 0, without a step. */
  static SteadyFlow none(FlowOptions options, double porosity, Percolation percolation) {
    return new SteadyFlow(
        options,
        porosity,
        0,
        percolation,
        0,
        options.sides() == Sides.PERIODIC ? Optional.of(PermeabilityColumn.ZERO) : Optional.empty(),
        0,
        0,
        0,
        true,
        0,
        new Chosen(Double.NaN, Double.NaN, 0),
        new Work(0, 0, 0, 0, new LoopStats(0, 0, List.of())),
        Optional.empty(),
        Optional.empty(),
        Optional.empty());
  }

  /** The pore space in which the flow was solved. */
  public PoreSpace solved() {
    return percolation.connected();
  }
}
