package org.hdispatch.porous.survey;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.porous.darcy.PermeabilityColumn;
import org.hdispatch.porous.darcy.PermeabilityTensor;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;

/**
 * What the flows along all three axes tell of one block; a block that does not percolate along an
 * axis has the permeability 0 there.
 *
 * @param block number of the block
 * @param box where it lies
 * @param rows its rows, one for each axis
 */
public record BlockTensor(long block, VoxelBox box, Map<Axis, SurveyRow> rows) {
  /** The figure of a row that holds its permeability along the flow, voxel². */
  public static final String PERMEABILITY = "permeability_voxel2";

  /**
   * Checks the rows and keeps a copy.
   *
   * @throws IllegalArgumentException if an axis has no row, or its row no permeability that counts
   */
  public BlockTensor {
    rows = Map.copyOf(rows);
    for (Axis axis : Axis.values()) {
      SurveyRow row = rows.get(axis);
      if (row == null || !isKnown(row)) {
        throw new IllegalArgumentException(
            "block must have a permeability along each axis: block=" + block + ", axis=" + axis);
      }
    }
  }

  /** The figure of a row that holds what flows along an axis, voxel². */
  public static String entry(Axis along) {
    return "permeability_" + along.name().toLowerCase(Locale.ROOT) + "_voxel2";
  }

  static boolean isKnown(SurveyRow row) {
    boolean counts =
        row.status() == SurveyStatus.DONE || row.status() == SurveyStatus.DOES_NOT_PERCOLATE;
    return counts && row.number(PERMEABILITY).isPresent();
  }

  /** Permeability along an axis, voxel². */
  public double diagonal(Axis axis) {
    return rows.get(axis).number(PERMEABILITY).getAsDouble();
  }

  /** The full tensor, voxel²; empty if the sides of the block were not periodic. */
  public Optional<PermeabilityTensor> tensor() {
    List<PermeabilityColumn> columns = new ArrayList<>();
    for (Axis axis : Axis.values()) {
      double[] entries = new double[3];
      for (Axis along : Axis.values()) {
        OptionalDouble entry = rows.get(axis).number(entry(along));
        if (entry.isEmpty()) {
          return Optional.empty();
        }
        entries[along.ordinal()] = entry.getAsDouble();
      }
      columns.add(new PermeabilityColumn(entries[0], entries[1], entries[2]));
    }
    return Optional.of(new PermeabilityTensor(columns.get(0), columns.get(1), columns.get(2)));
  }
}
