package org.hdispatch.app;

import java.util.Optional;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.SteadyFlow;
import org.hdispatch.porous.pore.PoreSpace;

/** A permeability as one flat row, for programs: the keys stay as they are. */
final class OutcomeRow {
  private OutcomeRow() {}

  static FlatRow of(Outcome outcome) {
    FlatRow row = new FlatRow();
    result(row, outcome);
    settings(row, outcome);
    outcome.collectorReport().putInto(row);
    details(row, outcome);
    return row.putAll(outcome.rock().origin());
  }

  private static void result(FlatRow row, Outcome outcome) {
    SteadyFlow flow = outcome.flow();
    row.put("permeability_m2", outcome.permeability().squareMetres())
        .put("permeability_mD", outcome.permeability().milliDarcy())
        .put("permeability_voxel2", flow.permeability())
        .put("k_error_estimate", flow.errorEstimate())
        .put("change_at_stop", flow.changeAtStop())
        .put("porosity", flow.porosity())
        .put("porosity_connected", outcome.connectedPorosity())
        .put("percolates", outcome.percolates())
        .put("converged", flow.converged())
        .put("steps", flow.work().steps())
        .put("tau", flow.chosen().relaxationTime())
        .put("superficial_velocity", outcome.superficialVelocity())
        .put("pore_velocity", outcome.poreVelocity())
        .put("reynolds", outcome.reynolds())
        .put("mach", flow.mach())
        .put("seconds_stepping", flow.work().secondsStepping())
        .put("mflups", flow.work().mflups());
  }

  private static void settings(FlatRow row, Outcome outcome) {
    FlowOptions options = outcome.options();
    boolean lattice = outcome.method() == Method.LBM;
    row.put("threads", outcome.threads())
        .put("method", Choices.word(outcome.method()))
        .put("lattice", lattice ? options.velocitySet().name() : null)
        .put("collision", lattice ? Choices.word(options.collision()) : null)
        .put("axis", Choices.word(options.axis()))
        .put("voxel_edge_m", outcome.rock().voxelEdge())
        .put("sides", Choices.word(options.sides()))
        .put("inlet", Choices.word(options.inlet()))
        .put("inlet_layers", outcome.flow().chosen().inletLayers());
  }

  private static void details(FlatRow row, Outcome outcome) {
    SteadyFlow flow = outcome.flow();
    PoreSpace space = outcome.rock().space();
    row.put("approach", Choices.word(outcome.options().approach()))
        .put(
            "storage",
            outcome.method() == Method.LBM ? Choices.word(outcome.options().storage()) : null)
        .put("corrections", flow.corrections().map(SteadyFlow.Corrections::count).orElse(0))
        .put(
            "seconds_pressure", flow.corrections().map(SteadyFlow.Corrections::seconds).orElse(0.0))
        .put("flux_imbalance", flow.fluxImbalance())
        .put("tolerance", outcome.options().tolerance())
        .put("max_steps", outcome.options().maxSteps())
        .put("viscosity", outcome.fluid().viscosity())
        .put("density", outcome.fluid().density())
        .put("pressure_gradient", outcome.fluid().pressureGradient())
        .put("nx", space.nx())
        .put("ny", space.ny())
        .put("nz", space.nz())
        .put("fluid_nodes", flow.work().fluidNodes())
        .put("hydraulic_diameter_voxel", flow.chosen().hydraulicDiameter())
        .put("spanning_clusters", flow.percolation().spanningClusters())
        .put("isolated_pore_voxels", flow.percolation().isolatedPoreVoxels())
        .put("walls", outcome.method() == Method.LBM ? Choices.word(outcome.walls()) : null)
        .put("version", Version.ofProject())
        .put("java", Version.ofJava());
    Optional<SteadyFlow.ParticleFigures> particles = flow.particles();
    row.put("particles", particles.map(SteadyFlow.ParticleFigures::count).orElse(null))
        .put(
            "smoothing_length_voxel",
            particles.map(SteadyFlow.ParticleFigures::smoothingLength).orElse(null))
        .put(
            "density_least",
            particles.map(SteadyFlow.ParticleFigures::leastCompression).orElse(null))
        .put(
            "density_greatest",
            particles.map(SteadyFlow.ParticleFigures::mostCompression).orElse(null));
  }
}
