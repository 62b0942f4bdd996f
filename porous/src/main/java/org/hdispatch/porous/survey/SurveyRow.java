package org.hdispatch.porous.survey;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;

/**
 * What was found of one job. Nothing in it depends on the machine, on the number of threads or on
 * the time it took: the same job gives the same row.
 *
 * @param job the job
 * @param status what became of it
 * @param cause why there is no result; empty if there is one
 * @param figures all else: column, value; an empty value is unknown
 */
public record SurveyRow(
    SurveyJob job, SurveyStatus status, String cause, Map<String, String> figures)
    implements Serializable {
  /** The columns that every table begins with; sizes are in voxels of the image. */
  private static final List<String> FIRST =
      List.of(
          "job", "block", "axis", "x0", "y0", "z0", "size_x", "size_y", "size_z", "status",
          "cause");

  /** Keeps an unchangeable copy of the figures, and the cause in one line. */
  public SurveyRow {
    cause = cause.replaceAll("\\s*\\R\\s*", " ");
    figures = Map.copyOf(figures);
  }

  /**
   * The columns of a table.
   *
   * @param figures those of {@link #figures()}
   */
  public static List<String> columns(List<String> figures) {
    List<String> all = new ArrayList<>(FIRST);
    all.addAll(figures);
    return all;
  }

  /** The figures among the columns of a table: all that {@link #columns} did not put there. */
  static List<String> figuresOf(List<String> columns) {
    return columns.subList(Math.min(FIRST.size(), columns.size()), columns.size());
  }

  /**
   * The row as values.
   *
   * @param columns as {@link #columns} gives them
   * @return a value for each column; figures that are not there are empty
   */
  public List<String> format(List<String> columns) {
    VoxelBox box = job.box();
    List<String> values =
        new ArrayList<>(
            List.of(
                Integer.toString(job.number()),
                Long.toString(job.block()),
                job.axis().name().toLowerCase(Locale.ROOT),
                Integer.toString(box.x0()),
                Integer.toString(box.y0()),
                Integer.toString(box.z0()),
                Integer.toString(box.nx()),
                Integer.toString(box.ny()),
                Integer.toString(box.nz()),
                status.word(),
                cause));
    for (String column : columns.subList(FIRST.size(), columns.size())) {
      values.add(figures.getOrDefault(column, ""));
    }
    return values;
  }

  /**
   * The row of some values.
   *
   * @param columns as {@link #columns} gives them
   * @param values a value for each column
   * @throws IllegalArgumentException if a value cannot be meant so
   */
  public static SurveyRow parse(List<String> columns, List<String> values) {
    if (values.size() != columns.size()) {
      throw new IllegalArgumentException(
          "row must have " + columns.size() + " values: values=" + values.size());
    }
    int[] box = new int[6];
    for (int n = 0; n < box.length; n++) {
      box[n] = Integer.parseInt(values.get(3 + n));
    }
    SurveyJob job =
        new SurveyJob(
            Integer.parseInt(values.get(0)),
            Long.parseLong(values.get(1)),
            new VoxelBox(box[0], box[1], box[2], box[3], box[4], box[5]),
            Axis.valueOf(values.get(2).toUpperCase(Locale.ROOT)));
    Map<String, String> figures = new LinkedHashMap<>();
    for (int n = FIRST.size(); n < columns.size(); n++) {
      figures.put(columns.get(n), values.get(n));
    }
    return new SurveyRow(job, SurveyStatus.of(values.get(9)), values.get(10), figures);
  }

  /**
   * A figure as a number.
   *
   * @param column its column
   * @return empty if it is unknown
   * @throws NumberFormatException if it is not a number
   */
  public OptionalDouble number(String column) {
    String value = figures.getOrDefault(column, "");
    return value.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(Double.parseDouble(value));
  }
}
