package org.hdispatch.app;

import java.util.List;
import java.util.Set;
import org.hdispatch.porous.survey.SurveyRow;

/** What stands in the tables of a survey. */
final class SurveyColumns {
  /** Of an inspection: what can be said of a block without a flow. */
  static final List<String> INSPECTED =
      List.of(
          "outside_fraction",
          "percolates_x",
          "percolates_y",
          "percolates_z",
          "porosity_connected_x",
          "porosity_connected_y",
          "porosity_connected_z");

  /** Of a permeability, as its own row calls them; none of them depends on the machine. */
  static final List<String> COMPUTED =
      List.of(
          "permeability_m2",
          "permeability_mD",
          "permeability_voxel2",
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
          "mach",
          "inlet_layers",
          "corrections",
          "flux_imbalance",
          "nx",
          "ny",
          "nz",
          "fluid_nodes",
          "hydraulic_diameter_voxel",
          "spanning_clusters",
          "isolated_pore_voxels",
          "particles",
          "density_least",
          "density_greatest");

  /** Of the settings: the same in all rows. The voxel edge is that of the refined rock. */
  static final List<String> SETTINGS =
      List.of(
          "method",
          "sides",
          "inlet",
          "lattice",
          "storage",
          "collision",
          "walls",
          "approach",
          "tolerance",
          "max_steps",
          "smoothing_length_voxel",
          "refine",
          "voxel_edge_m",
          "viscosity",
          "density",
          "pressure_gradient",
          "image",
          "pore_values",
          "solid_fraction_range",
          "outside",
          "version");

  /** All columns of {@link SurveyRow#figures()}. */
  static final List<String> FIGURES =
      List.of(COMPUTED, INSPECTED, SETTINGS).stream().flatMap(List::stream).toList();

  /** Columns of times: what depends on the machine. */
  static final List<String> TIMES =
      List.of(
          "job", "seconds", "seconds_stepping", "seconds_pressure", "mflups", "threads", "java");

  /** Columns that are texts even where they look like numbers. */
  private static final Set<String> TEXTS =
      Set.of("cause", "image", "pore_values", "solid_fraction_range", "outside", "version", "java");

  private SurveyColumns() {}

  /** A row for programs, numbers as numbers. */
  static FlatRow flat(SurveyRow row) {
    List<String> columns = SurveyRow.columns(FIGURES);
    List<String> values = row.format(columns);
    FlatRow flat = new FlatRow();
    for (int n = 0; n < columns.size(); n++) {
      flat.put(columns.get(n), value(columns.get(n), values.get(n)));
    }
    return flat;
  }

  private static Object value(String column, String text) {
    if (text.isEmpty()) {
      return null;
    }
    if (TEXTS.contains(column)) {
      return text;
    }
    if (text.equals("true") || text.equals("false")) {
      return Boolean.valueOf(text);
    }
    if (text.matches("-?\\d+")) {
      return Long.valueOf(text);
    }
    return text.matches("-?\\d+\\.\\d+(E-?\\d+)?") ? (Object) Double.valueOf(text) : text;
  }
}
