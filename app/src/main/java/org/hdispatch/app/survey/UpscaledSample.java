package org.hdispatch.app.survey;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.survey.SurveyStatus;
import org.hdispatch.porous.survey.SurveyTable;
import org.hdispatch.porous.upscale.BlockMap;
import org.hdispatch.porous.upscale.Bounds;
import org.hdispatch.porous.upscale.Upscaling;

/**
 * The permeability of a surveyed sample from that of its blocks, for people and programs.
 *
 * @param survey the survey
 * @param map its blocks
 * @param axes what was found along each axis that was surveyed
 */
record UpscaledSample(SurveyTable survey, BlockMap map, List<Along> axes) {
  private static final int DIGITS = 4;

  /**
   * What was found along an axis.
   *
   * @param axis the axis
   * @param bounds what its permeability lies between
   * @param result its permeability; empty if blocks were not surveyed across it
   */
  record Along(Axis axis, Bounds bounds, Optional<Upscaling.Result> result) {}

  private long count(Axis axis, SurveyStatus status) {
    return survey.rows().stream()
        .filter(row -> row.job().axis() == axis && row.status() == status)
        .count();
  }

  private long outside() {
    return count(axes.get(0).axis(), SurveyStatus.OUTSIDE);
  }

  /** Places within the sample of which the survey has no block. */
  private long leftOut() {
    return map.places() - map.blocks() - outside();
  }

  private int corner(Axis axis) {
    return survey.rows().stream()
        .map(row -> row.job().box())
        .mapToInt(box -> axis.length(box.x0(), box.y0(), box.z0()))
        .min()
        .getAsInt();
  }

  /** The part of the image that the blocks cover, holes included. */
  private VoxelBox box() {
    return new VoxelBox(
        corner(Axis.X),
        corner(Axis.Y),
        corner(Axis.Z),
        map.nx() * map.block().nx(),
        map.ny() * map.block().ny(),
        map.nz() * map.block().nz());
  }

  private String figure(String name) {
    return survey.rows().get(0).figures().getOrDefault(name, "");
  }

  private OptionalDouble edge() {
    return survey.rows().get(0).number("voxel_edge_m");
  }

  private double errorOfBlocks(Axis axis) {
    return survey.rows().stream()
        .filter(row -> row.job().axis() == axis)
        .map(row -> row.number("k_error_estimate"))
        .flatMapToDouble(OptionalDouble::stream)
        .max()
        .orElse(0);
  }

  /** Whether a permeability is one that did not converge, of a block or of the sample. */
  boolean isUnsteady() {
    return axes.stream()
        .anyMatch(
            each ->
                count(each.axis(), SurveyStatus.NOT_CONVERGED) > 0
                    || each.result().isPresent() && !each.result().get().converged());
  }

  /** A row for each axis, for programs. */
  List<FlatRow> rows() {
    return axes.stream().map(this::row).toList();
  }

  private FlatRow row(Along along) {
    Optional<Upscaling.Result> result = along.result();
    Optional<Permeability> k = result.map(found -> new Permeability(found.permeability(), edge()));
    Bounds bounds = along.bounds();
    FlatRow row =
        new FlatRow()
            .put("axis", Choices.word(along.axis()))
            .put(
                "permeability_m2", k.map(Permeability::squareMetres).orElse(OptionalDouble.empty()))
            .put("permeability_mD", k.map(Permeability::milliDarcy).orElse(OptionalDouble.empty()))
            .put("permeability_voxel2", result.map(Upscaling.Result::permeability).orElse(null));
    bound(row, "columns", bounds.columns());
    bound(row, "layers", bounds.layers());
    bound(row, "harmonic", bounds.harmonic());
    bound(row, "arithmetic", bounds.arithmetic());
    VoxelBox box = box();
    return row.put("percolates", result.map(Upscaling.Result::percolates).orElse(null))
        .put("converged", result.map(Upscaling.Result::converged).orElse(null))
        .put("iterations", result.map(Upscaling.Result::iterations).orElse(null))
        .put("flux_imbalance", result.map(Upscaling.Result::imbalance).orElse(null))
        .put("places_x", map.nx())
        .put("places_y", map.ny())
        .put("places_z", map.nz())
        .put("blocks", map.blocks())
        .put("outside", outside())
        .put("left_out", leftOut())
        .put("does_not_percolate", count(along.axis(), SurveyStatus.DOES_NOT_PERCOLATE))
        .put("not_converged", count(along.axis(), SurveyStatus.NOT_CONVERGED))
        .put("k_error_estimate_of_blocks", errorOfBlocks(along.axis()))
        .put("block", map.block().toString())
        .put("box", box.toString())
        .put("sides", figure("sides"))
        .put("inlet", figure("inlet"))
        .put("method", figure("method"))
        .put("voxel_edge_m", edge())
        .put("image", figure("image"))
        .put("image_size", survey.settings().values().get("image_size"))
        .put("version", Version.ofProject());
  }

  private void bound(FlatRow row, String name, double voxel2) {
    row.put(name + "_mD", new Permeability(voxel2, edge()).milliDarcy())
        .put(name + "_voxel2", voxel2);
  }

  private String milliDarcy(double voxel2) {
    OptionalDouble k = new Permeability(voxel2, edge()).milliDarcy();
    return Numbers.significant(k.orElse(voxel2), DIGITS);
  }

  private String unit() {
    return edge().isPresent() ? " mD" : " voxel2";
  }

  /** For people. */
  Table table() {
    Table table = new Table();
    table
        .line("image", figure("image") + ", " + survey.settings().values().get("image_size"))
        .line(
            "blocks",
            map.blocks()
                + " of "
                + map.block()
                + " voxels, in "
                + map.nx()
                + " x "
                + map.ny()
                + " x "
                + map.nz()
                + " places: box "
                + box());
    if (outside() > 0) {
      table.line("outside", outside() + " places: nothing flows there");
    }
    if (leftOut() > 0) {
      table.line("left out", leftOut() + " places: not surveyed, taken as if nothing flowed there");
    }
    table.line(
        "boundaries of blocks",
        "sides " + figure("sides") + ", inlet and outlet " + figure("inlet"));
    for (Along each : axes) {
      along(table, each);
    }
    if (axes.get(0).result().isEmpty()) {
      table.line("", "only bounds: blocks must be surveyed along all three axes (--axis all)");
    }
    return table;
  }

  private void along(Table table, Along along) {
    Bounds bounds = along.bounds();
    String name = "along " + Choices.word(along.axis());
    if (along.result().isPresent()) {
      Upscaling.Result found = along.result().get();
      table.line(
          name,
          milliDarcy(found.permeability())
              + unit()
              + (found.percolates() ? "" : ", NO way leads through")
              + (found.converged() ? "" : ", NOT CONVERGED"));
      name = "";
    }
    table
        .line(
            name,
            "bounds: "
                + milliDarcy(bounds.columns())
                + " (columns side by side) to "
                + milliDarcy(bounds.layers())
                + unit()
                + " (layers in series)")
        .line(
            "",
            "means of blocks: harmonic "
                + milliDarcy(bounds.harmonic())
                + ", arithmetic "
                + milliDarcy(bounds.arithmetic())
                + unit());
    long tight = count(along.axis(), SurveyStatus.DOES_NOT_PERCOLATE);
    long unsteady = count(along.axis(), SurveyStatus.NOT_CONVERGED);
    if (tight > 0) {
      table.line("", tight + " blocks do not percolate: k = 0");
    }
    if (unsteady > 0) {
      table.line("", unsteady + " blocks did NOT CONVERGE: taken with the k they came to");
    }
  }
}
