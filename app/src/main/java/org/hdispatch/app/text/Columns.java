package org.hdispatch.app.text;

import java.util.ArrayList;
import java.util.List;

/** Lines of columns as wide as what stands in them, aligned right but for the first. */
public final class Columns {
  private static final String GAP = "  ";

  private final List<String[]> lines = new ArrayList<>();

  /** Adds a line; all have as many columns as the first. */
  public Columns line(String... columns) {
    lines.add(columns);
    return this;
  }

  @Override
  public String toString() {
    int[] widths = new int[lines.get(0).length];
    for (String[] line : lines) {
      for (int n = 0; n < widths.length; n++) {
        widths[n] = Math.max(widths[n], line[n].length());
      }
    }
    StringBuilder text = new StringBuilder();
    for (String[] line : lines) {
      StringBuilder row = new StringBuilder();
      for (int n = 0; n < widths.length; n++) {
        String blank = " ".repeat(widths[n] - line[n].length());
        row.append(n == 0 ? line[n] + blank : GAP + blank + line[n]);
      }
      text.append(row.toString().stripTrailing()).append(System.lineSeparator());
    }
    return text.toString();
  }
}
