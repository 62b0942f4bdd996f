package org.hdispatch.app;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.hdispatch.dispatch.LoopStats;
import org.hdispatch.gc.GcWatch;
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
    collector(row, outcome);
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
    row.put("threads", outcome.threads())
        .put("method", "lbm")
        .put("lattice", options.velocitySet().name())
        .put("collision", Choices.word(options.collision()))
        .put("axis", Choices.word(options.axis()))
        .put("voxel_edge_m", outcome.rock().voxelEdge())
        .put("sides", Choices.word(options.sides()))
        .put("inlet", Choices.word(options.inlet()))
        .put("inlet_layers", outcome.flow().chosen().inletLayers());
  }

  private static void collector(FlatRow row, Outcome outcome) {
    Optional<CollectorWatch.Window> after = outcome.collector().map(CollectorWatch.Figures::after);
    Optional<CollectorWatch.Window> warmUp =
        outcome.collector().map(CollectorWatch.Figures::warmUp);
    row.put("collector", GcWatch.collector())
        .put("collections", after.map(CollectorWatch.Window::collections).orElse(null))
        .put("gc_pause_ms", millis(after, CollectorWatch.Window::pauseMillis))
        .put("stopped_ms", millis(after, CollectorWatch.Window::stoppedMillis))
        .put("stall_ms", millis(after, CollectorWatch.Window::stallMillis))
        .put("bytes_per_step", bytes(outcome))
        .put("collections_warm_up", warmUp.map(CollectorWatch.Window::collections).orElse(null))
        .put("gc_pause_ms_warm_up", millis(warmUp, CollectorWatch.Window::pauseMillis))
        .put("warm_up_steps", outcome.flow().work().warmUpSteps());
  }

  private static Long bytes(Outcome outcome) {
    long bytes = outcome.flow().work().stats().bytesPerStep();
    return bytes == LoopStats.NOT_MEASURED ? null : bytes;
  }

  private static OptionalDouble millis(
      Optional<CollectorWatch.Window> window,
      Function<CollectorWatch.Window, OptionalDouble> figure) {
    return window.map(figure).orElse(OptionalDouble.empty());
  }

  private static void details(FlatRow row, Outcome outcome) {
    SteadyFlow flow = outcome.flow();
    PoreSpace space = outcome.rock().space();
    row.put("tolerance", outcome.options().tolerance())
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
        .put("version", Version.ofProject())
        .put("java", Version.ofJava());
  }
}
