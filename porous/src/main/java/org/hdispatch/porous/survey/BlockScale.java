package org.hdispatch.porous.survey;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;

/**
 * What blocks of one size say of a rock. Where the means of two sizes agree and the spread is
 * small, a block of this size represents the rock (a representative elementary volume).
 *
 * @param block size of the blocks
 * @param porosity of the blocks, each once
 * @param permeability along each axis that was computed, mD; a block that does not percolate
 *     counts, with its k = 0, one without a result does not
 * @param dead how many of the permeabilities are those of blocks that do not percolate
 */
public record BlockScale(
    Extent block, Spread porosity, Map<Axis, Spread> permeability, Map<Axis, Integer> dead) {
  /** Keeps unchangeable copies of the maps. */
  public BlockScale {
    permeability = Collections.unmodifiableMap(new EnumMap<>(permeability));
    dead = Collections.unmodifiableMap(new EnumMap<>(dead));
  }

  /** Edge of the cube that is as large as a block, voxels. */
  public double edge() {
    return edgeOf(block);
  }

  private static double edgeOf(Extent block) {
    return Math.cbrt((double) block.nx() * block.ny() * block.nz());
  }

  /**
   * What rows of one rock and one method say, for each size of blocks, the smallest first.
   *
   * @param rows of one survey or of several; the same job twice counts once, by its last row
   */
  public static List<BlockScale> of(List<SurveyRow> rows) {
    Map<Extent, List<SurveyRow>> sizes = new LinkedHashMap<>();
    for (SurveyRow row : rows) {
      VoxelBox box = row.job().box();
      sizes
          .computeIfAbsent(new Extent(box.nx(), box.ny(), box.nz()), key -> new ArrayList<>())
          .add(row);
    }
    return sizes.entrySet().stream()
        .map(each -> of(each.getKey(), each.getValue()))
        .sorted(Comparator.comparingDouble(BlockScale::edge))
        .toList();
  }

  private static BlockScale of(Extent block, List<SurveyRow> rows) {
    Map<Axis, Spread> permeability = new EnumMap<>(Axis.class);
    Map<Axis, Integer> dead = new EnumMap<>(Axis.class);
    for (Axis axis : Axis.values()) {
      Spread found =
          Spread.of(
              values(
                  rows,
                  "permeability_mD",
                  row -> row.job().axis() == axis && row.status().hasPermeability()));
      if (found.count() > 0) {
        permeability.put(axis, found);
        dead.put(
            axis,
            (int)
                rows.stream()
                    .filter(row -> row.job().axis() == axis)
                    .filter(row -> row.status() == SurveyStatus.DOES_NOT_PERCOLATE)
                    .map(row -> row.job().box())
                    .distinct()
                    .count());
      }
    }
    return new BlockScale(
        block, Spread.of(values(rows, "porosity", row -> true)), permeability, dead);
  }

  /** The values of a column, one for each box. */
  private static double[] values(List<SurveyRow> rows, String column, Predicate<SurveyRow> wanted) {
    Map<String, Double> values = new TreeMap<>();
    for (SurveyRow row : rows) {
      if (wanted.test(row)) {
        row.number(column).ifPresent(each -> values.put(row.job().box().toString(), each));
      }
    }
    return values.values().stream().mapToDouble(Double::doubleValue).toArray();
  }
}
