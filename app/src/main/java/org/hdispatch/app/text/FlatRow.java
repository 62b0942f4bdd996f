package org.hdispatch.app.text;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.StringJoiner;
import java.util.function.BiConsumer;
import org.hdispatch.porous.io.CsvLine;

/**
 * One result as keys and values in their order; a value is a string, a number, a truth value, or
 * unknown.
 */
public final class FlatRow {
  private final Map<String, Object> values = new LinkedHashMap<>();

  /** Adds a value; null, NaN and infinities are unknown. */
  public FlatRow put(String key, Object value) {
    boolean unknown = value instanceof Double number && !Double.isFinite(number);
    values.put(key, unknown ? null : value);
    return this;
  }

  /** Adds a number that may be unknown. */
  public FlatRow put(String key, OptionalDouble value) {
    return put(key, value.isPresent() ? (Object) value.getAsDouble() : null);
  }

  /** Adds all of these. */
  public FlatRow putAll(Map<String, ?> more) {
    more.forEach(this::put);
    return this;
  }

  /** A JSON array of such objects. */
  public static String toJson(List<FlatRow> rows) {
    StringJoiner json = new StringJoiner(",\n", "[\n", "\n]\n");
    rows.forEach(row -> json.add(row.toJson().stripTrailing()));
    return json.toString();
  }

  /** A JSON object of a row that sums up, {@code summary}, and the {@code rows} themselves. */
  public static String toJson(FlatRow summary, List<FlatRow> rows) {
    return "{\n\"summary\": "
        + summary.toJson().stripTrailing()
        + ",\n\"rows\": "
        + toJson(rows).stripTrailing()
        + "\n}\n";
  }

  /** One JSON object (RFC 8259); unknown is {@code null}. */
  public String toJson() {
    StringJoiner json = new StringJoiner(",\n  ", "{\n  ", "\n}\n");
    values.forEach((key, value) -> json.add(quoted(key) + ": " + jsonValue(value)));
    return json.toString();
  }

  private static String jsonValue(Object value) {
    return value == null || value instanceof Number || value instanceof Boolean
        ? String.valueOf(value)
        : quoted(value.toString());
  }

  private static String quoted(String text) {
    StringBuilder json = new StringBuilder("\"");
    for (char c : text.toCharArray()) {
      if (c == '"' || c == '\\') {
        json.append('\\').append(c);
      } else if (c < ' ') {
        json.append(String.format("\\u%04x", (int) c));
      } else {
        json.append(c);
      }
    }
    return json.append('"').toString();
  }

  /** A header and one row (RFC 4180); unknown is an empty field. */
  public String toCsv() {
    return toCsv(List.of(this));
  }

  /** A header, and a row for each of these, which have the same keys. */
  public static String toCsv(List<FlatRow> rows) {
    StringBuilder csv = new StringBuilder();
    csv.append(CsvLine.format(List.copyOf(rows.get(0).values.keySet()))).append('\n');
    for (FlatRow row : rows) {
      csv.append(CsvLine.format(row.values.keySet().stream().map(row::text).toList())).append('\n');
    }
    return csv.toString();
  }

  /** Tells all keys and their values as text. */
  public void forEach(BiConsumer<String, String> listener) {
    values.keySet().forEach(key -> listener.accept(key, text(key)));
  }

  /** A value as text; empty if it is unknown. */
  String text(String key) {
    Object value = values.get(key);
    return value == null ? "" : value.toString();
  }
}
