package org.hdispatch.porous.survey;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.io.CsvLine;
import org.hdispatch.porous.io.ImageFileException;

/**
 * A porosity and a permeability from elsewhere, of a laboratory or of another program, to lay
 * beside those of a survey.
 *
 * @param label whose it is; points of one label belong together
 * @param porosity a fraction, 0 to 1
 * @param permeability mD, not negative
 * @param axis direction of the flow, if known
 * @param block number of the block of a survey that it is of, if any
 * @param edge edge of that block, voxels, if known
 * @param image which image that is of, if known: a part of the name that the survey has for it
 */
public record GivenPoint(
    String label,
    double porosity,
    double permeability,
    Optional<Axis> axis,
    OptionalLong block,
    OptionalDouble edge,
    Optional<String> image) {
  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if porosity is not between 0 and 1, or permeability is
   *     negative or not finite
   */
  public GivenPoint {
    if (!(porosity >= 0 && porosity <= 1)) {
      throw new IllegalArgumentException(
          "porosity must be a fraction, 0 to 1: porosity=" + porosity);
    }
    if (!(permeability >= 0 && permeability < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "permeability must not be negative: k=" + permeability + " mD");
    }
  }

  /**
   * Reads points from a CSV file with a header. Lines that begin with # are left out. Columns, in
   * any order: {@code label}, {@code porosity}, {@code permeability_mD} or {@code
   * permeability_voxel2} with {@code voxel_edge_m}; and, for points that are of a block of a
   * survey, {@code block}, {@code axis}, {@code size} (its edge, voxels) and {@code image}, any of
   * which may be empty. Other columns are passed over.
   *
   * @throws ImageFileException if it cannot be read, a column is missing, or a value is not what it
   *     should be
   */
  public static List<GivenPoint> read(Path file) throws ImageFileException {
    List<String> lines;
    try {
      lines = Files.readAllLines(file);
    } catch (IOException e) {
      throw new ImageFileException("points must be readable: file=" + file + ", cause=" + e, e);
    }
    List<GivenPoint> points = new ArrayList<>();
    List<String> columns = List.of();
    for (int n = 0; n < lines.size(); n++) {
      String line = lines.get(n);
      if (line.isBlank() || line.startsWith("#")) {
        continue;
      }
      try {
        List<String> values = CsvLine.parse(line).stream().map(String::strip).toList();
        if (columns.isEmpty()) {
          columns = values;
        } else {
          points.add(parse(columns, values));
        }
      } catch (IllegalArgumentException e) {
        throw new ImageFileException(
            "point must be one of the table: file="
                + file
                + ", line="
                + (n + 1)
                + ", cause="
                + e.getMessage(),
            e);
      }
    }
    if (points.isEmpty()) {
      throw new ImageFileException("table must hold points: file=" + file);
    }
    return points;
  }

  private static GivenPoint parse(List<String> columns, List<String> values) {
    if (values.size() != columns.size()) {
      throw new IllegalArgumentException(
          "values must be as many as columns: values=" + values.size());
    }
    Map<String, String> row = new LinkedHashMap<>();
    for (int n = 0; n < columns.size(); n++) {
      if (!values.get(n).isEmpty()) {
        row.put(columns.get(n), values.get(n));
      }
    }
    double permeability;
    if (row.containsKey("permeability_mD")) {
      permeability = Double.parseDouble(row.get("permeability_mD"));
    } else {
      double voxel2 = Double.parseDouble(required(row, "permeability_voxel2"));
      double edge = Double.parseDouble(required(row, "voxel_edge_m"));
      permeability = new Permeability(voxel2, OptionalDouble.of(edge)).milliDarcy().getAsDouble();
    }
    return new GivenPoint(
        required(row, "label"),
        Double.parseDouble(required(row, "porosity")),
        permeability,
        Optional.ofNullable(row.get("axis")).map(GivenPoint::axis),
        row.containsKey("block")
            ? OptionalLong.of(Long.parseLong(row.get("block")))
            : OptionalLong.empty(),
        row.containsKey("size")
            ? OptionalDouble.of(Double.parseDouble(row.get("size")))
            : OptionalDouble.empty(),
        Optional.ofNullable(row.get("image")));
  }

  private static Axis axis(String word) {
    return Axis.valueOf(word.toUpperCase(Locale.ROOT));
  }

  private static String required(Map<String, String> row, String column) {
    if (!row.containsKey(column)) {
      throw new IllegalArgumentException(column + " must be given");
    }
    return row.get(column);
  }

  /** Whether a row of a survey is of the same block and axis; false if this says of neither. */
  private boolean isOf(SurveyRow row, String imageOfRow) {
    return block.isPresent()
        && axis.isPresent()
        && block.getAsLong() == row.job().block()
        && axis.get() == row.job().axis()
        && (edge.isEmpty() || edge.getAsDouble() == row.job().box().nx())
        && (image.isEmpty() || imageOfRow.contains(image.get()));
  }

  /**
   * Permeabilities of a survey over those of points of the same block and axis.
   *
   * @param rows the survey; blocks without a converged flow are left out
   * @param image what the survey calls its image
   * @param points given ones; those of permeability 0 are left out
   */
  public static Spread ratios(List<SurveyRow> rows, String image, List<GivenPoint> points) {
    List<Double> ratios = new ArrayList<>();
    for (SurveyRow row : rows) {
      for (GivenPoint point : points) {
        boolean both =
            row.status() == SurveyStatus.DONE && point.permeability() > 0 && point.isOf(row, image);
        if (both) {
          row.number("permeability_mD").ifPresent(k -> ratios.add(k / point.permeability()));
        }
      }
    }
    return Spread.of(ratios.stream().mapToDouble(Double::doubleValue).toArray());
  }
}
