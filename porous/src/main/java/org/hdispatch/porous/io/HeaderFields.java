package org.hdispatch.porous.io;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.VoxelBox;

/** The fields of a text header, by name, and what the formats ask of them alike. */
final class HeaderFields {
  /** Two spacings that differ by less are the same number, written by different programs. */
  private static final double SAME_SPACING = 1e-6;

  /** How many of a unit make a metre: dividing by these rounds as the decimal number does. */
  private static final Map<String, Double> IN_A_METRE =
      Map.ofEntries(
          Map.entry("m", 1.0),
          Map.entry("meter", 1.0),
          Map.entry("metre", 1.0),
          Map.entry("cm", 1e2),
          Map.entry("mm", 1e3),
          Map.entry("millimeter", 1e3),
          Map.entry("millimetre", 1e3),
          Map.entry("um", 1e6),
          Map.entry("\u00b5m", 1e6), // micro sign
          Map.entry("\u03bcm", 1e6), // Greek mu
          Map.entry("micron", 1e6),
          Map.entry("micrometer", 1e6),
          Map.entry("micrometre", 1e6),
          Map.entry("nm", 1e9));

  private final Path file;
  private final Map<String, String> values = new LinkedHashMap<>();

  HeaderFields(Path file) {
    this.file = file;
  }

  /** Adds a field, which must not be there yet. */
  void put(String name, String value) throws ImageFileException {
    if (values.put(name, value.strip()) != null) {
      throw wrong("header must state each field once", name);
    }
  }

  /** A field that may be there. */
  Optional<String> find(String name) {
    return Optional.ofNullable(values.get(name));
  }

  /** A field that must be there. */
  String get(String name) throws ImageFileException {
    String value = values.get(name);
    if (value == null) {
      throw new ImageFileException("header must have the field '" + name + "': file=" + file);
    }
    return value;
  }

  /** A whole number. */
  long integer(String name, long absent) throws ImageFileException {
    String value = values.get(name);
    try {
      return value == null ? absent : Long.parseLong(value);
    } catch (NumberFormatException e) {
      throw wrong("field must be a whole number", name);
    }
  }

  /** True or false, in any case. */
  boolean flag(String name, boolean absent) throws ImageFileException {
    String value = values.getOrDefault(name, Boolean.toString(absent)).toLowerCase(Locale.ROOT);
    if (!value.equals("true") && !value.equals("false")) {
      throw wrong("field must be True or False", name);
    }
    return value.equals("true");
  }

  /** The size of an image of 3 dimensions, x first. */
  VoxelBox size(String name) throws ImageFileException {
    String value = get(name);
    if (!value.matches("[1-9]\\d{0,9}(\\s+[1-9]\\d{0,9}){2}")) {
      throw wrong("image must have 3 dimensions (x y z)", name);
    }
    long[] n = new long[3];
    for (int i = 0; i < 3; i++) {
      n[i] = Long.parseLong(value.split("\\s+")[i]);
      if (n[i] > Integer.MAX_VALUE) {
        throw wrong("dimensions must be 1 to " + Integer.MAX_VALUE, name);
      }
    }
    return VoxelBox.whole((int) n[0], (int) n[1], (int) n[2]);
  }

  /** Three numbers, separated by blanks. */
  double[] three(String name) throws ImageFileException {
    String[] words = get(name).split("\\s+");
    double[] numbers = new double[words.length];
    try {
      for (int i = 0; i < words.length; i++) {
        numbers[i] = Double.parseDouble(words[i]);
      }
    } catch (NumberFormatException e) {
      throw wrong("field must be numbers", name);
    }
    if (numbers.length != 3) {
      throw wrong("field must be 3 numbers (x y z)", name);
    }
    return numbers;
  }

  /**
   * The edge of cubic voxels; empty where the unit is not stated or none that is known.
   *
   * @param name the field that the spacings come from
   * @param spacings distances of voxel centres along x, y and z
   * @param unit their unit
   * @throws ImageFileException if they are not positive and equal, as voxels must be cubes
   */
  OptionalDouble edge(String name, double[] spacings, Optional<String> unit)
      throws ImageFileException {
    for (double spacing : spacings) {
      boolean same = Math.abs(spacing - spacings[0]) <= SAME_SPACING * spacings[0];
      if (!(spacing > 0) || spacing == Double.POSITIVE_INFINITY || !same) {
        throw wrong(
            "voxels must be cubes, of the same positive edge along all axes (resample the image,"
                + " or correct its header)",
            name);
      }
    }
    Double inAMetre =
        IN_A_METRE.get(unit.orElse("").toLowerCase(Locale.ROOT).replaceFirst("(..)s$", "$1"));
    return inAMetre == null ? OptionalDouble.empty() : OptionalDouble.of(spacings[0] / inAMetre);
  }

  /** A refusal that shows a field. */
  ImageFileException wrong(String must, String name) {
    return new ImageFileException(
        must + ": file=" + file + ", " + name.replace(' ', '_') + "=" + values.get(name));
  }
}
