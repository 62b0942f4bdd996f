package org.hdispatch.app.rock;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.block.Walls;
import org.hdispatch.porous.flow.Approach;
import org.hdispatch.porous.flow.CollisionModel;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.Inlet;
import org.hdispatch.porous.flow.Sides;
import org.hdispatch.porous.image.Axis;
import picocli.CommandLine.Option;

/** How the flow is computed, its direction apart. */
public final class FlowSettings {
  @Option(
      names = "--tolerance",
      paramLabel = "E",
      description = "Estimated relative error of k at which to stop.")
  private double tolerance = FlowOptions.DEFAULT.tolerance();

  @Option(
      names = "--approach",
      paramLabel = "APPROACH",
      defaultValue = "corrected",
      completionCandidates = Choices.OfApproach.class,
      description =
          "How to get to the steady state: ${COMPLETION-CANDIDATES}. With corrected, pressure starts"
              + " from Darcy's law between the nodes and is corrected every few steps; plain starts"
              + " from rest and takes thousands of steps in tight rock (--walls imb: plain).")
  private Approach approach;

  @Option(
      names = "--max-steps",
      paramLabel = "N",
      description = "Steps after which to give up (exit code 4).")
  private long maxSteps = FlowOptions.DEFAULT.maxSteps();

  @Option(
      names = "--lattice",
      paramLabel = "LATTICE",
      description = "Velocity set: ${COMPLETION-CANDIDATES} (--walls imb: D3Q15).")
  private VelocitySet lattice = FlowOptions.DEFAULT.velocitySet();

  @Option(
      names = "--storage",
      paramLabel = "PRECISION",
      defaultValue = "double",
      completionCandidates = Choices.OfStorage.class,
      description =
          "Precision of the populations: ${COMPLETION-CANDIDATES}. Single takes half their memory;"
              + " k differs by some 1e-5 of itself.")
  private Storage storage;

  @Option(
      names = "--collision",
      paramLabel = "MODEL",
      defaultValue = "trt",
      completionCandidates = Choices.OfCollision.class,
      description =
          "Collision: ${COMPLETION-CANDIDATES} (--walls imb: bgk)."
              + " With trt and bounce-back, k does not depend on tau.")
  private CollisionModel collision;

  @Option(
      names = "--tau",
      paramLabel = "T",
      description =
          "Relaxation time, steps; above 0.5. It sets how many steps it takes."
              + " Default: chosen from the pore space (--walls imb: 0.6, where it is right).")
  private Double tau;

  @Option(
      names = "--walls",
      paramLabel = "WALLS",
      defaultValue = "bounce-back",
      completionCandidates = Choices.OfWalls.class,
      converter = WallsConverter.class,
      description =
          "Walls of the pores: ${COMPLETION-CANDIDATES}. With imb, immersed boundaries, voxels may be"
              + " solid in part: spheres exactly, images by --solid-fraction-range.")
  private Walls walls;

  @Option(
      names = "--solid-fraction-range",
      paramLabel = "PORE,SOLID",
      split = ",",
      hideParamSyntax = true,
      description =
          "With --walls imb, for a grey-scale image in place of a segmented one: the grey values, 0 to"
              + " 255, of pure pore and pure solid; between them a voxel is solid in part."
              + " Default: none, the image is segmented, for which imb brings nothing.")
  private List<Integer> solidFractionRange;

  @Option(
      names = "--sides",
      paramLabel = "SIDES",
      defaultValue = "wall",
      completionCandidates = Choices.OfSides.class,
      description =
          "The four sides along the flow: ${COMPLETION-CANDIDATES} (spheres: periodic)."
              + " Mirror is as if the rock's mirror image lay beside it, without its voxels.")
  private Sides sides;

  @Option(
      names = "--inlet",
      paramLabel = "INLET",
      defaultValue = "slab",
      completionCandidates = Choices.OfInlet.class,
      description =
          "The two ends of the flow: ${COMPLETION-CANDIDATES} (spheres: periodic)."
              + " A slab is layers of fluid between the rock and its periodic image."
              + " With pressure, a plenum begins right at the rock: as if it lay beside its mirror"
              + " image, without its voxels.")
  private Inlet inlet;

  @Option(
      names = "--inlet-layers",
      paramLabel = "B",
      description =
          "Layers of fluid at each end, if --inlet is slab. Default: three quarters of the pores'"
              + " hydraulic diameter, from where on k hardly depends on it.")
  private Integer inletLayers;

  /** How the fluid sees the walls. */
  public Walls walls() {
    return walls;
  }

  /** Grey values of pore and solid, if given. */
  public Optional<List<Integer>> solidFractionRange() {
    if (solidFractionRange != null && solidFractionRange.size() != 2) {
      throw new UsageException(
          "--solid-fraction-range must be 2 integers: --solid-fraction-range="
              + solidFractionRange);
    }
    return Optional.ofNullable(solidFractionRange);
  }

  /**
   * The settings for an image, along z.
   *
   * @throws UsageException if one is out of its bounds
   */
  FlowOptions options() {
    return UsageException.orRefused(
        () ->
            new FlowOptions(
                Axis.Z,
                lattice,
                storage,
                collision,
                tau == null ? OptionalDouble.empty() : OptionalDouble.of(tau),
                sides,
                inlet,
                inletLayers == null ? OptionalInt.empty() : OptionalInt.of(inletLayers),
                approach,
                tolerance,
                maxSteps));
  }
}
