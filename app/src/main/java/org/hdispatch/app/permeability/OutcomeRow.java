package org.hdispatch.app.permeability;

import java.util.Map;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.porous.block.Method;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.SteadyFlow;

/** A permeability as one flat row, for programs: the keys stay as they are. */
final class OutcomeRow {
  private OutcomeRow() {}

  static FlatRow of(Outcome outcome) {
    Map<String, Object> figures = outcome.figures().values(outcome.rock().space());
    FlatRow row = new FlatRow();
    result(row, outcome, figures);
    settings(row, outcome, figures);
    outcome.collectorReport().putInto(row);
    details(row, outcome, figures);
    return row.putAll(outcome.rock().origin());
  }

  private static void put(FlatRow row, Map<String, Object> figures, String... keys) {
    for (String key : keys) {
      row.put(key, figures.get(key));
    }
  }

  private static void result(FlatRow row, Outcome outcome, Map<String, Object> figures) {
    put(
        row,
        figures,
        "permeability_m2",
        "permeability_mD",
        "permeability_voxel2",
        "permeability_x_voxel2",
        "permeability_y_voxel2",
        "permeability_z_voxel2",
        "k_error_estimate",
        "change_at_stop",
        "porosity",
        "porosity_connected",
        "percolates",
        "converged",
        "steps",
        "tau",
        "superficial_velocity",
        "pore_velocity",
        "reynolds",
        "mach");
    row.put("seconds_stepping", outcome.flow().work().secondsStepping())
        .put("mflups", outcome.flow().work().mflups());
  }

  private static void settings(FlatRow row, Outcome outcome, Map<String, Object> figures) {
    FlowOptions options = outcome.options();
    boolean lattice = outcome.method() == Method.LBM;
    row.put("threads", outcome.threads())
        .put("method", Choices.word(outcome.method()))
        .put("lattice", lattice ? options.velocitySet().name() : null)
        .put("collision", lattice ? Choices.word(options.collision()) : null)
        .put("axis", Choices.word(options.axis()))
        .put("voxel_edge_m", outcome.rock().voxelEdge())
        .put("sides", Choices.word(options.sides()))
        .put("inlet", Choices.word(options.inlet()));
    put(row, figures, "inlet_layers");
  }

  private static void details(FlatRow row, Outcome outcome, Map<String, Object> figures) {
    SteadyFlow flow = outcome.flow();
    boolean lattice = outcome.method() == Method.LBM;
    row.put("approach", Choices.word(outcome.options().approach()))
        .put("storage", lattice ? Choices.word(outcome.options().storage()) : null);
    put(row, figures, "corrections");
    row.put(
        "seconds_pressure", flow.corrections().map(SteadyFlow.Corrections::seconds).orElse(0.0));
    put(row, figures, "flux_imbalance");
    row.put("tolerance", outcome.options().tolerance())
        .put("max_steps", outcome.options().maxSteps())
        .put("viscosity", outcome.fluid().viscosity())
        .put("density", outcome.fluid().density())
        .put("pressure_gradient", outcome.fluid().pressureGradient());
    put(
        row,
        figures,
        "nx",
        "ny",
        "nz",
        "fluid_nodes",
        "hydraulic_diameter_voxel",
        "spanning_clusters",
        "isolated_pore_voxels");
    row.put("walls", lattice ? Choices.word(outcome.walls()) : null)
        .put("version", Version.ofProject())
        .put("java", Version.ofJava());
    put(row, figures, "particles", "smoothing_length_voxel", "density_least", "density_greatest");
  }
}
