package org.hdispatch.app.survey;

import java.util.List;
import java.util.Set;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.porous.block.BlockColumns;
import org.hdispatch.porous.survey.SurveyRow;

/** Rows of a survey for programs. */
final class SurveyColumns {
  /** Columns that are texts even where they look like numbers. */
  private static final Set<String> TEXTS =
      Set.of("cause", "image", "pore_values", "solid_fraction_range", "outside", "version", "java");

  private SurveyColumns() {}

  /** A row for programs, numbers as numbers. */
  static FlatRow flat(SurveyRow row) {
    List<String> columns = SurveyRow.columns(BlockColumns.FIGURES);
    List<String> values = row.format(columns);
    FlatRow flat = new FlatRow();
    for (int n = 0; n < columns.size(); n++) {
      flat.put(columns.get(n), value(columns.get(n), values.get(n)));
    }
    return flat;
  }

  private static Object value(String column, String text) {
    if (text.isEmpty()) {
      return null;
    }
    if (TEXTS.contains(column)) {
      return text;
    }
    if (text.equals("true") || text.equals("false")) {
      return Boolean.valueOf(text);
    }
    if (text.matches("-?\\d+")) {
      return Long.valueOf(text);
    }
    return text.matches("-?\\d+\\.\\d+(E-?\\d+)?") ? (Object) Double.valueOf(text) : text;
  }
}
