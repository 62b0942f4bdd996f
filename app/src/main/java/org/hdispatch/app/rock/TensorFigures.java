package org.hdispatch.app.rock;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.darcy.PermeabilityColumn;
import org.hdispatch.porous.darcy.PermeabilityTensor;
import org.hdispatch.porous.darcy.PermeabilityTensor.Principal;
import org.hdispatch.porous.image.Axis;

/**
 * A permeability tensor for people and programs.
 *
 * @param diagonal permeability along each axis, voxel²
 * @param tensor all of it, voxel²; empty if the sides were not periodic, as nothing flows across
 * @param voxelEdge edge of a voxel, m, if known
 */
public record TensorFigures(
    List<Double> diagonal, Optional<PermeabilityTensor> tensor, OptionalDouble voxelEdge) {
  private static final int DIGITS = 5;
  private static final int FEW = 3;

  /**
   * The tensor of three flows.
   *
   * @param diagonal permeability along each axis, voxel²
   * @param columns what each of them gave
   */
  public static TensorFigures of(
      List<Double> diagonal, List<Optional<PermeabilityColumn>> columns, OptionalDouble voxelEdge) {
    Optional<PermeabilityTensor> tensor =
        columns.stream().allMatch(Optional::isPresent)
            ? Optional.of(
                new PermeabilityTensor(
                    columns.get(0).get(), columns.get(1).get(), columns.get(2).get()))
            : Optional.empty();
    return new TensorFigures(diagonal, tensor, voxelEdge);
  }

  private OptionalDouble entry(Axis row, Axis column) {
    if (tensor.isPresent()) {
      return OptionalDouble.of(tensor.get().entry(row.ordinal(), column.ordinal()));
    }
    return row == column ? OptionalDouble.of(diagonal.get(row.ordinal())) : OptionalDouble.empty();
  }

  private OptionalDouble milliDarcy(double voxel2) {
    return new Permeability(voxel2, voxelEdge).milliDarcy();
  }

  /** Greatest over least permeability along an axis; empty where one is 0. */
  public OptionalDouble diagonalRatio() {
    double least = Math.min(diagonal.get(0), Math.min(diagonal.get(1), diagonal.get(2)));
    double most = Math.max(diagonal.get(0), Math.max(diagonal.get(1), diagonal.get(2)));
    return least > 0 ? OptionalDouble.of(most / least) : OptionalDouble.empty();
  }

  /** Adds it to a row: entries row by row, then what follows from them. */
  public FlatRow putInto(FlatRow row) {
    for (Axis flux : Axis.values()) {
      for (Axis gradient : Axis.values()) {
        String entry = Choices.word(flux) + Choices.word(gradient);
        row.put("permeability_" + entry + "_voxel2", entry(flux, gradient));
      }
    }
    row.put("diagonal_ratio", diagonalRatio())
        .put("asymmetry", tensor.map(PermeabilityTensor::asymmetry).orElse(null))
        .put(
            "anisotropy",
            tensor.map(PermeabilityTensor::anisotropy).orElse(OptionalDouble.empty()));
    for (int n = 0; n < 3; n++) {
      int which = n;
      String name = "principal_" + (n + 1);
      Optional<Principal> found = tensor.map(each -> each.principal().get(which));
      row.put(name + "_voxel2", found.map(Principal::value).orElse(null))
          .put(
              name + "_mD",
              found.map(each -> milliDarcy(each.value())).orElse(OptionalDouble.empty()))
          .put(name + "_x", found.map(Principal::x).orElse(null))
          .put(name + "_y", found.map(Principal::y).orElse(null))
          .put(name + "_z", found.map(Principal::z).orElse(null));
    }
    return row;
  }

  /** As lines for people. */
  public void putInto(Table table) {
    if (tensor.isEmpty()) {
      table.line(
          "tensor",
          "its diagonal alone, greatest over least "
              + ratio(diagonalRatio())
              + "; what flows across needs --sides periodic");
      return;
    }
    String name = "tensor, voxel2";
    for (Axis flux : Axis.values()) {
      List<String> entries = new ArrayList<>();
      for (Axis gradient : Axis.values()) {
        entries.add(
            String.format(
                "%12s", Numbers.significant(entry(flux, gradient).getAsDouble(), DIGITS)));
      }
      table.line(name, String.join(" ", entries));
      name = "";
    }
    table.line("asymmetry", Numbers.percent(tensor.get().asymmetry()));
    name = "principal values";
    for (Principal each : tensor.get().principal()) {
      OptionalDouble inMilliDarcy = milliDarcy(each.value());
      table.line(
          name,
          (inMilliDarcy.isPresent()
                  ? Numbers.significant(inMilliDarcy.getAsDouble(), DIGITS) + " mD"
                  : Numbers.significant(each.value(), DIGITS) + " voxel2")
              + String.format(
                  Locale.ROOT, " along (%.3f, %.3f, %.3f)", each.x(), each.y(), each.z()));
      name = "";
    }
    table.line("anisotropy", ratio(tensor.get().anisotropy()));
  }

  private static String ratio(OptionalDouble ratio) {
    return ratio.isPresent()
        ? Numbers.significant(ratio.getAsDouble(), FEW)
        : "unknown (nothing flows one way)";
  }
}
