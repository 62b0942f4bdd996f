package org.hdispatch.porous.survey;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;

/**
 * What the rows of a survey depend on. All processes that write into one folder must agree in it.
 *
 * @param values name, value, in the order in which they are kept
 */
public record SurveySettings(Map<String, String> values) {
  /** The setting that says how many jobs there are. */
  public static final String JOBS = "jobs";

  /**
   * The setting that tells one image from another: a checksum of some of its blocks. It is not
   * there if one of them could not be read, and then it is not compared.
   */
  public static final String BLOCKS_CRC = "blocks_crc";

  private static final String FIRST_LINE = "# what the rows of this survey depend on";
  private static final String LAST_LINE = "# end";

  /**
   * Keeps an unchangeable copy.
   *
   * @throws IllegalArgumentException if the number of jobs is missing or a text has a line end
   */
  public SurveySettings {
    values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    if (!values.containsKey(JOBS)) {
      throw new IllegalArgumentException("settings must say how many jobs there are");
    }
    values.forEach(
        (name, value) -> {
          if (value.lines().count() > 1) {
            throw new IllegalArgumentException("setting must be one line: " + name + "=" + value);
          }
        });
  }

  /** How many jobs there are. */
  public int jobs() {
    return Integer.parseInt(values.get(JOBS));
  }

  /** The first setting in which this differs from another, as {@code name=here, there=other}. */
  Optional<String> difference(SurveySettings other) {
    TreeSet<String> names = new TreeSet<>(values.keySet());
    names.addAll(other.values.keySet());
    if (!values.containsKey(BLOCKS_CRC) || !other.values.containsKey(BLOCKS_CRC)) {
      names.remove(BLOCKS_CRC);
    }
    for (String name : names) {
      String here = values.getOrDefault(name, "");
      String there = other.values.getOrDefault(name, "");
      if (!here.equals(there)) {
        return Optional.of(name + "=" + here + ", there=" + there);
      }
    }
    return Optional.empty();
  }

  /** As a file holds them. */
  String format() {
    StringBuilder text = new StringBuilder(FIRST_LINE).append('\n');
    values.forEach((name, value) -> text.append(name).append('=').append(value).append('\n'));
    return text.append(LAST_LINE).append('\n').toString();
  }

  /** The settings that a file holds; empty if it was not written to its end. */
  static Optional<SurveySettings> parse(String text) {
    if (!text.endsWith("\n" + LAST_LINE + "\n")) {
      return Optional.empty();
    }
    Map<String, String> values = new LinkedHashMap<>();
    text.lines()
        .filter(line -> !line.startsWith("#"))
        .forEach(
            line -> {
              int equals = line.indexOf('=');
              if (equals > 0) {
                values.put(line.substring(0, equals), line.substring(equals + 1));
              }
            });
    return values.containsKey(JOBS) ? Optional.of(new SurveySettings(values)) : Optional.empty();
  }
}
