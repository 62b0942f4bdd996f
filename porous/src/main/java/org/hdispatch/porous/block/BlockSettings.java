package org.hdispatch.porous.block;

import java.io.Serializable;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.darcy.PhysicalFlow;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.SolidFractions;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.VoxelImage;

/**
 * What the row of a block depends on, the block itself apart.
 *
 * @param rule which labels are pore, if the image is segmented
 * @param voxelEdge edge of a voxel of the image, m
 * @param refine how many voxels an edge of one is cut into
 * @param walls how the walls of the pores are made
 * @param grey grey values of pure pore and pure solid, if walls are immersed and the image is not
 *     segmented; or empty
 * @param outsideLabels labels of voxels outside the sample
 * @param outside what becomes of blocks that have them
 * @param choice how flows are computed, but for their axis
 * @param fluid fluid and drive
 */
public record BlockSettings(
    LabelRule rule,
    double voxelEdge,
    int refine,
    Walls walls,
    List<Integer> grey,
    List<Integer> outsideLabels,
    Outside outside,
    FlowChoice choice,
    PhysicalFlow fluid)
    implements Serializable {
  /** Why walls that are immersed are not refined. */
  public static final String NOT_REFINED =
      "--refine must come with voxels that are solid or not: walls=imb";

  /**
   * Keeps copies of the lists.
   *
   * @throws IllegalArgumentException if one is out of its bounds, a label lies outside and in the
   *     pores, or they do not go together
   */
  public BlockSettings {
    grey = List.copyOf(grey);
    outsideLabels = List.copyOf(outsideLabels);
    new Permeability(0, OptionalDouble.of(voxelEdge)); // which checks the edge
    if (refine < 1) {
      throw new IllegalArgumentException("voxels must be cut into at least 1: refine=" + refine);
    }
    if (refine > 1 && walls == Walls.IMB) {
      throw new IllegalArgumentException(NOT_REFINED);
    }
    if (!grey.isEmpty() && (grey.size() != 2 || walls != Walls.IMB)) {
      throw new IllegalArgumentException(
          "grey values must be those of pore and solid, and walls be immersed: grey="
              + grey
              + ", walls="
              + walls);
    }
    if (!grey.isEmpty()) { // which checks them
      SolidFractions.ofGrey(VoxelImage.of(1, 1, 1, new byte[1]), grey.get(0), grey.get(1));
    }
    for (int label : outsideLabels) {
      if (label < 0 || label >= VoxelImage.LABELS) {
        throw new IllegalArgumentException("outside value must be within 0 to 255: label=" + label);
      }
      if (grey.isEmpty() && rule.poreLabels().contains(label)) {
        throw new IllegalArgumentException(
            "outside value must be no pore value (give --pore-value): label=" + label);
      }
    }
  }

  /**
   * What the command line takes if nothing is given: 1 is pore, water, walls of bounce-back, no
   * outside, {@link FlowChoice#DEFAULT}.
   *
   * @param voxelEdge edge of a voxel, m
   */
  public static BlockSettings of(double voxelEdge) {
    return new BlockSettings(
        LabelRule.poreIs(1),
        voxelEdge,
        1,
        Walls.BOUNCE_BACK,
        List.of(),
        List.of(),
        Outside.FLAG,
        FlowChoice.DEFAULT,
        PhysicalFlow.WATER);
  }

  /** A copy with another way to compute flows. */
  public BlockSettings withChoice(FlowChoice other) {
    return new BlockSettings(
        rule, voxelEdge, refine, walls, grey, outsideLabels, outside, other, fluid);
  }

  /** A copy with other labels outside the sample. */
  public BlockSettings withOutside(List<Integer> labels, Outside what) {
    return new BlockSettings(rule, voxelEdge, refine, walls, grey, labels, what, choice, fluid);
  }

  /** What is set, by its name, as {@code survey.properties} has it. */
  Map<String, String> values() {
    FlowOptions options = choice.options();
    Map<String, String> values = new LinkedHashMap<>();
    values.put(
        "outside", outsideLabels.isEmpty() ? "" : word(outside) + " " + joined(outsideLabels));
    values.put("voxel_edge_m", Double.toString(voxelEdge));
    values.put("refine", Integer.toString(refine));
    values.put("method", word(choice.method()));
    values.put("sides", word(options.sides()));
    values.put("inlet", word(options.inlet()));
    values.put(
        "inlet_layers",
        options.inletLayers().isPresent() ? "" + options.inletLayers().getAsInt() : "chosen");
    values.put("approach", word(options.approach()));
    values.put("tolerance", Double.toString(options.tolerance()));
    values.put("max_steps", Long.toString(options.maxSteps()));
    values.put("viscosity", Double.toString(fluid.viscosity()));
    values.put("density", Double.toString(fluid.density()));
    values.put("pressure_gradient", Double.toString(fluid.pressureGradient()));
    if (grey.isEmpty()) {
      values.put("pore_values", rule.toString().replace("pore=", ""));
    } else {
      values.put("solid_fraction_range", joined(grey));
    }
    if (choice.method() == Method.LBM) {
      values.put("lattice", options.velocitySet().name());
      values.put("storage", word(options.storage()));
      values.put("collision", word(options.collision()));
      values.put(
          "tau",
          options.relaxationTime().isPresent()
              ? Double.toString(options.relaxationTime().getAsDouble())
              : "chosen");
      values.put("walls", word(walls));
    } else {
      values.put("smoothing_length", Double.toString(choice.particles().smoothingLength()));
      values.put("wall_factor", Double.toString(choice.particles().wallFactor()));
    }
    values.put("version", version());
    return values;
  }

  /** Version of the project, from the manifest of its jar; {@code development} of loose classes. */
  public static String version() {
    String version = BlockSettings.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }

  private static String joined(List<Integer> values) {
    return String.join(",", values.stream().map(Object::toString).toList());
  }

  /** The word for a value of an enumeration: its name in lower case, hyphens between words. */
  static String word(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
