package org.hdispatch.porous.block;

import java.util.List;
import org.hdispatch.porous.survey.SurveyRow;

/** What stands in the tables of a survey. */
public final class BlockColumns {
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
  public static final List<String> FIGURES =
      List.of(COMPUTED, INSPECTED, SETTINGS).stream().flatMap(List::stream).toList();

  /** Columns of times: what depends on the machine. */
  public static final List<String> TIMES =
      List.of(
          "job", "seconds", "seconds_stepping", "seconds_pressure", "mflups", "threads", "java");

  private BlockColumns() {}
}
