package org.hdispatch.app.survey;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.hdispatch.app.rock.TensorFigures;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.porous.darcy.PermeabilityTensor;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.survey.BlockTensor;
import org.hdispatch.porous.survey.BlockTensors;
import org.hdispatch.porous.survey.Spread;
import org.hdispatch.porous.survey.SurveyRow;

/**
 * The permeability tensors of the blocks of a survey that have all three axes, and what they come
 * to.
 */
final class SurveyTensors {
  private static final int DIGITS = 4;

  private final BlockTensors tensors = new BlockTensors();
  private final List<Double> anisotropies = new ArrayList<>(); // of full tensors
  private final List<Double> ratios = new ArrayList<>(); // greatest over least of the diagonal
  private int blocks;
  private int full;
  private double asymmetry = Double.NaN; // the greatest

  /**
   * Takes in a row of the survey; they come in the order of their jobs, block by block.
   *
   * @return the row of the block that it completes
   */
  Optional<FlatRow> add(SurveyRow row) {
    Optional<BlockTensor> found = tensors.add(row);
    found.ifPresent(this::count);
    return found.map(SurveyTensors::row);
  }

  private void count(BlockTensor block) {
    blocks++;
    figures(block).diagonalRatio().ifPresent(ratios::add);
    Optional<PermeabilityTensor> tensor = block.tensor();
    if (tensor.isPresent()) {
      full++;
      tensor.get().anisotropy().ifPresent(anisotropies::add);
      double found = tensor.get().asymmetry();
      asymmetry = asymmetry >= found ? asymmetry : found;
    }
  }

  /** How many blocks have all three axes. */
  int blocks() {
    return blocks;
  }

  private static TensorFigures figures(BlockTensor block) {
    OptionalDouble edge = block.rows().get(Axis.X).number("voxel_edge_m");
    List<Double> diagonal = Stream.of(Axis.values()).map(block::diagonal).toList();
    return new TensorFigures(diagonal, block.tensor(), edge);
  }

  private static FlatRow row(BlockTensor block) {
    VoxelBox box = block.box();
    SurveyRow first = block.rows().get(Axis.X);
    double error = 0;
    for (SurveyRow each : block.rows().values()) {
      error = Math.max(error, each.number("k_error_estimate").orElse(0));
    }
    FlatRow row =
        new FlatRow()
            .put("block", block.block())
            .put("x0", box.x0())
            .put("y0", box.y0())
            .put("z0", box.z0())
            .put("size_x", box.nx())
            .put("size_y", box.ny())
            .put("size_z", box.nz())
            .put("porosity", first.number("porosity"))
            .put("sides", first.figures().get("sides"))
            .put("inlet", first.figures().get("inlet"))
            .put("voxel_edge_m", first.number("voxel_edge_m"))
            .put("k_error_estimate", error);
    return figures(block).putInto(row);
  }

  private boolean areFull() {
    return blocks > 0 && full == blocks;
  }

  private static Spread spread(List<Double> values) {
    return Spread.of(values.stream().mapToDouble(Double::doubleValue).toArray());
  }

  /** What they come to, for programs. */
  void putInto(FlatRow summary) {
    summary.put("tensor_blocks", blocks);
    put(summary, "anisotropy", spread(anisotropies));
    put(summary, "diagonal_ratio", spread(ratios));
    summary.put("asymmetry_greatest", asymmetry);
  }

  private static void put(FlatRow summary, String name, Spread spread) {
    summary
        .put(name + "_count", spread.count())
        .put(name + "_least", spread.least())
        .put(name + "_median", spread.median())
        .put(name + "_greatest", spread.greatest());
  }

  /** What they come to, for people. */
  void putInto(Table table) {
    if (blocks == 0) {
      return;
    }
    table.line(
        "tensor",
        (areFull() ? "full, in " : "its diagonal alone, in ")
            + blocks
            + (blocks == 1 ? " block" : " blocks")
            + (areFull() ? "" : "; what flows across needs --sides periodic"));
    Spread spread = spread(areFull() ? anisotropies : ratios);
    if (spread.count() > 0) {
      table.line(
          areFull() ? "anisotropy" : "greatest/least axis",
          "median "
              + Numbers.significant(spread.median(), DIGITS)
              + ", "
              + Numbers.significant(spread.least(), DIGITS)
              + " to "
              + Numbers.significant(spread.greatest(), DIGITS)
              + " in "
              + spread.count());
    }
    if (areFull()) {
      table.line("asymmetry", "at most " + Numbers.percent(asymmetry));
    }
  }
}
