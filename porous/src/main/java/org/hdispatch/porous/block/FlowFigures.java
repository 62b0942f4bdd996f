package org.hdispatch.porous.block;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.darcy.PhysicalFlow;
import org.hdispatch.porous.flow.SteadyFlow;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;

/**
 * What a steady flow comes to in physical units.
 *
 * @param flow the flow, in voxel units
 * @param voxelEdge edge of a voxel of it, m, if known
 * @param fluid fluid and drive
 */
public record FlowFigures(SteadyFlow flow, OptionalDouble voxelEdge, PhysicalFlow fluid) {
  /** The permeability. */
  public Permeability permeability() {
    return new Permeability(flow.permeability(), voxelEdge);
  }

  /**
   * What flows along an axis under the pressure gradient along that of the flow, as an entry of the
   * permeability tensor, voxel²: along the flow k; across it only with periodic sides.
   */
  public OptionalDouble entry(Axis along) {
    if (flow.column().isPresent()) {
      return OptionalDouble.of(flow.column().get().entry(along.ordinal()));
    }
    return along == flow.options().axis()
        ? OptionalDouble.of(flow.permeability())
        : OptionalDouble.empty();
  }

  private boolean percolates() {
    return flow.percolation().percolates();
  }

  /** Superficial (Darcy) velocity, m/s, if the voxel edge is known. */
  public OptionalDouble superficialVelocity() {
    return fluid.superficialVelocity(permeability());
  }

  /** Mean velocity within the connected pores, m/s, if the voxel edge is known. */
  public OptionalDouble poreVelocity() {
    OptionalDouble q = superficialVelocity();
    return q.isEmpty() || !percolates()
        ? q
        : OptionalDouble.of(q.getAsDouble() / flow.connectedPorosity());
  }

  /** Reynolds number of the pore velocity and the hydraulic diameter, if the edge is known. */
  public OptionalDouble reynolds() {
    OptionalDouble u = poreVelocity();
    if (u.isEmpty() || !percolates()) {
      return u;
    }
    double diameter = flow.chosen().hydraulicDiameter() * voxelEdge.getAsDouble();
    return OptionalDouble.of(fluid.reynolds(u.getAsDouble(), diameter));
  }

  /**
   * All figures that do not depend on the machine, as tables call them.
   *
   * @param space the pore space of the rock
   * @return key, value; null is unknown
   */
  public Map<String, Object> values(PoreSpace space) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("permeability_m2", known(permeability().squareMetres()));
    values.put("permeability_mD", known(permeability().milliDarcy()));
    values.put("permeability_voxel2", known(flow.permeability()));
    values.put("permeability_x_voxel2", known(entry(Axis.X)));
    values.put("permeability_y_voxel2", known(entry(Axis.Y)));
    values.put("permeability_z_voxel2", known(entry(Axis.Z)));
    values.put("k_error_estimate", known(flow.errorEstimate()));
    values.put("change_at_stop", known(flow.changeAtStop()));
    values.put("porosity", known(flow.porosity()));
    values.put("porosity_connected", known(flow.connectedPorosity()));
    values.put("percolates", percolates());
    values.put("converged", flow.converged());
    values.put("steps", flow.work().steps());
    values.put("tau", known(flow.chosen().relaxationTime()));
    values.put("superficial_velocity", known(superficialVelocity()));
    values.put("pore_velocity", known(poreVelocity()));
    values.put("reynolds", known(reynolds()));
    values.put("mach", known(flow.mach()));
    values.put("inlet_layers", flow.chosen().inletLayers());
    values.put("corrections", flow.corrections().map(SteadyFlow.Corrections::count).orElse(0));
    values.put("flux_imbalance", known(flow.fluxImbalance()));
    values.put("nx", space.nx());
    values.put("ny", space.ny());
    values.put("nz", space.nz());
    values.put("fluid_nodes", flow.work().fluidNodes());
    values.put("hydraulic_diameter_voxel", known(flow.chosen().hydraulicDiameter()));
    values.put("spanning_clusters", flow.percolation().spanningClusters());
    values.put("isolated_pore_voxels", flow.percolation().isolatedPoreVoxels());
    Optional<SteadyFlow.ParticleFigures> particles = flow.particles();
    values.put("particles", particles.map(SteadyFlow.ParticleFigures::count).orElse(null));
    values.put(
        "smoothing_length_voxel",
        particles.map(SteadyFlow.ParticleFigures::smoothingLength).orElse(null));
    values.put(
        "density_least", particles.map(SteadyFlow.ParticleFigures::leastCompression).orElse(null));
    values.put(
        "density_greatest",
        particles.map(SteadyFlow.ParticleFigures::mostCompression).orElse(null));
    return values;
  }

  private static Double known(OptionalDouble value) {
    return value.isPresent() ? known(value.getAsDouble()) : null;
  }

  private static Double known(double value) {
    return Double.isFinite(value) ? value : null;
  }
}
