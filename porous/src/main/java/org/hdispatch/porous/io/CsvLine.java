package org.hdispatch.porous.io;

import java.util.ArrayList;
import java.util.List;
import java.util.StringJoiner;

/** A line of comma separated values (RFC 4180); its end is not part of it. */
public final class CsvLine {
  private CsvLine() {}

  /**
   * Values as a line; those with a comma, a quote or a line end are quoted.
   *
   * @param values the values, an empty text standing for the unknown
   * @return the line
   */
  public static String format(List<String> values) {
    StringJoiner line = new StringJoiner(",");
    values.forEach(value -> line.add(field(value)));
    return line.toString();
  }

  private static String field(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  /**
   * The values of a line.
   *
   * @param line a line as {@link #format} makes them
   * @return its values, at least one
   * @throws IllegalArgumentException if a quoted value does not end, or goes on behind its quote
   */
  public static List<String> parse(String line) {
    List<String> values = new ArrayList<>();
    int at = 0;
    while (true) {
      StringBuilder value = new StringBuilder();
      if (at < line.length() && line.charAt(at) == '"') {
        at = quoted(line, at + 1, value);
      } else {
        int comma = line.indexOf(',', at);
        int end = comma < 0 ? line.length() : comma;
        value.append(line, at, end);
        at = end;
      }
      values.add(value.toString());
      if (at == line.length()) {
        return values;
      }
      if (line.charAt(at) != ',') {
        throw new IllegalArgumentException("quoted value must end at a comma: line=" + line);
      }
      at++;
    }
  }

  /** Takes a value in behind its first quote; returns the place behind its last. */
  private static int quoted(String line, int from, StringBuilder value) {
    int at = from;
    while (true) {
      int quote = line.indexOf('"', at);
      if (quote < 0) {
        throw new IllegalArgumentException("quoted value must end: line=" + line);
      }
      value.append(line, at, quote);
      if (quote + 1 == line.length() || line.charAt(quote + 1) != '"') {
        return quote + 1;
      }
      value.append('"');
      at = quote + 2;
    }
  }
}
