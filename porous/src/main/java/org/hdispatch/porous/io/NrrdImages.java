package org.hdispatch.porous.io;

import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hdispatch.porous.image.VoxelBox;

/**
 * NRRD images (Teem's "Definition of NRRD File Format"): the header in front of the voxels ({@code
 * .nrrd}) or in a file of its own ({@code .nhdr}), 3 dimensions, the first being x, integers whose
 * values are within 0..255, raw or gzipped. No axis may be of a kind that is known not to be space,
 * such as the components of a colour.
 *
 * <p>The voxel edge comes from {@code space directions} with {@code space units}, or from {@code
 * spacings} with {@code units}; without a unit it is unknown, as the format has none by default.
 * Voxels must be cubes.
 */
public final class NrrdImages {
  private static final Pattern VECTOR = Pattern.compile("\\(([^()]*)\\)");
  private static final Pattern QUOTED = Pattern.compile("\"([^\"]*)\"");

  /** Kinds of axes that are, or may be, of space. */
  private static final Pattern KINDS =
      Pattern.compile(
          "(domain|space|none|\\?{3})(\\s+(domain|space|none|\\?{3})){2}",
          Pattern.CASE_INSENSITIVE);

  /** Two axes are at right angles if the cosine between them is below this. */
  private static final double RIGHT_ANGLE = 1e-5;

  private NrrdImages() {}

  /** Whether a file begins like this. */
  static boolean isStart(byte[] start) {
    return start.length >= 6
        && start[0] == 'N'
        && start[1] == 'R'
        && start[2] == 'R'
        && start[3] == 'D'
        && start[4] == '0'
        && start[5] == '0';
  }

  /**
   * The image in a file.
   *
   * @param file a file in NRRD format; the header, where it stands apart
   * @return the image, with its voxel edge where the header states it with a unit
   * @throws ImageFileException if a file is missing, not NRRD or of another length than its header
   *     says, or if the image has no 3 dimensions in space, no integers, no cubic voxels, or is
   *     stored in a way that is not read; the message names the remedy
   */
  public static ImageFile open(Path file) throws ImageFileException {
    HeaderText header = HeaderText.read(file, String::isEmpty);
    if (!header.lines().get(0).matches("NRRD(000\\d|00\\.01)")) {
      throw new ImageFileException(
          "file must be NRRD (its first line NRRD0001 to NRRD0005): file=" + file);
    }
    HeaderFields fields = fields(file, header);
    if (fields.integer("dimension", 3) != 3) {
      throw fields.wrong("image must have 3 dimensions (x y z)", "dimension");
    }
    requireSpace(fields);
    VoxelBox whole = fields.size("sizes");
    LabelType type = labelType(fields);
    FlatVolume.Packing packing = packing(fields);
    Path data = dataFile(file, fields);
    if (data.equals(file) && header.end().isEmpty()) {
      throw new ImageFileException("header must end with an empty line: file=" + file);
    }
    long start = start(fields, data, data.equals(file) ? header.end().get() : 0, packing, type);
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("type", type.toString());
    facts.put("encoding", packing == FlatVolume.Packing.GZIP ? "gzip" : "raw");
    if (!data.equals(file)) {
      facts.put("data_file", data.toString());
    }
    for (String field : new String[] {"space directions", "space units", "spacings", "units"}) {
      fields.find(field).ifPresent(value -> facts.put(field.replace(' ', '_'), value));
    }
    return FlatImage.of(
        ImageFormat.NRRD.toString(),
        file,
        new FlatVolume(data, start, packing, type, whole),
        FlatImage.Order.X_FASTEST,
        voxelEdge(fields),
        facts);
  }

  /** The fields, by their names in lower case; the forms without blanks are the same fields. */
  private static HeaderFields fields(Path file, HeaderText header) throws ImageFileException {
    HeaderFields fields = new HeaderFields(file);
    for (String line : header.lines().subList(1, header.lines().size())) {
      int colon = line.indexOf(':');
      boolean comment = line.startsWith("#") || line.isEmpty();
      boolean keyAndValue = colon >= 0 && line.startsWith(":=", colon);
      if (comment || keyAndValue) {
        continue;
      }
      if (colon < 0) {
        throw new ImageFileException(
            "header line must be 'field: value': file=" + file + ", line=" + line);
      }
      String name = line.substring(0, colon).strip().toLowerCase(Locale.ROOT);
      String field =
          switch (name) {
            case "datafile" -> "data file";
            case "byteskip" -> "byte skip";
            case "lineskip" -> "line skip";
            default -> name;
          };
      fields.put(field, line.substring(colon + 1));
    }
    return fields;
  }

  /** Kinds of axes may be left out; if they are there, none may be of colours, time or vectors. */
  private static void requireSpace(HeaderFields fields) throws ImageFileException {
    Optional<String> kinds = fields.find("kinds");
    if (kinds.isPresent() && !KINDS.matcher(kinds.get()).matches()) {
      throw fields.wrong(
          "axes must be of space: 3 kinds of domain, space, none or ??? (keep one component: unu"
              + " slice)",
          "kinds");
    }
  }

  private static LabelType labelType(HeaderFields fields) throws ImageFileException {
    String name = fields.get("type").toLowerCase(Locale.ROOT).replaceAll("\\s+", " ");
    // Teem's many names differ in "signed" and in "int" at the end; plain "char" is none of them.
    String plain =
        name.replaceFirst("^signed (?!char)", "").replaceFirst("(short|long) int$", "$1");
    LabelType little =
        switch (plain) {
          case "signed char", "int8", "int8_t" -> little(1, true);
          case "uchar", "unsigned char", "uint8", "uint8_t" -> little(1, false);
          case "short", "int16", "int16_t" -> little(2, true);
          case "ushort", "unsigned short", "uint16", "uint16_t" -> little(2, false);
          case "int", "int32", "int32_t" -> little(4, true);
          case "uint", "unsigned int", "uint32", "uint32_t" -> little(4, false);
          case "longlong", "long long", "int64", "int64_t" -> little(8, true);
          case "ulonglong", "unsigned long long", "uint64", "uint64_t" -> little(8, false);
          default -> null;
        };
    if (little == null) {
      throw fields.wrong("labels must be integers of 0..255 (convert them to uint8)", "type");
    }
    if (little.bytes() == 1) {
      return little;
    }
    return switch (fields.get("endian").toLowerCase(Locale.ROOT)) {
      case "little" -> little;
      case "big" -> new LabelType(little.bytes(), little.signed(), ByteOrder.BIG_ENDIAN);
      default -> throw fields.wrong("endian must be little or big", "endian");
    };
  }

  private static LabelType little(int bytes, boolean signed) {
    return new LabelType(bytes, signed, ByteOrder.LITTLE_ENDIAN);
  }

  private static FlatVolume.Packing packing(HeaderFields fields) throws ImageFileException {
    return switch (fields.get("encoding").toLowerCase(Locale.ROOT)) {
      case "raw" -> FlatVolume.Packing.PLAIN;
      case "gz", "gzip" -> FlatVolume.Packing.GZIP;
      default ->
          throw fields.wrong(
              "encoding must be raw or gzip (write it again: unu save -f nrrd -e gzip)",
              "encoding");
    };
  }

  private static Path dataFile(Path file, HeaderFields fields) throws ImageFileException {
    Optional<String> name = fields.find("data file");
    if (name.isEmpty()) {
      return file;
    }
    if (name.get().startsWith("LIST") || name.get().contains("%")) {
      throw fields.wrong("voxels must be in one data file (join its parts)", "data file");
    }
    return file.resolveSibling(name.get());
  }

  private static long start(
      HeaderFields fields, Path data, long header, FlatVolume.Packing packing, LabelType type)
      throws ImageFileException {
    long skip = fields.integer("byte skip", 0);
    if (fields.integer("line skip", 0) != 0) {
      throw fields.wrong("line skip must be 0 (give byte skip)", "line skip");
    }
    if (skip < -1 || skip != 0 && packing != FlatVolume.Packing.PLAIN) {
      throw fields.wrong("byte skip must be 0, or with raw encoding at least -1", "byte skip");
    }
    if (skip == -1) { // the voxels are what the file ends with
      return Math.max(
          header, ImageFiles.requireReadable(data) - FlatVolume.bytes(fields.size("sizes"), type));
    }
    return Math.addExact(header, skip);
  }

  private static OptionalDouble voxelEdge(HeaderFields fields) throws ImageFileException {
    if (fields.find("space directions").isPresent()) {
      double[] lengths = lengths(fields);
      return fields.edge("space directions", lengths, unit(fields, "space units"));
    }
    Optional<String> spacings = fields.find("spacings");
    // A spacing that is not a number is one that is not known.
    if (spacings.isEmpty() || spacings.get().toLowerCase(Locale.ROOT).contains("nan")) {
      return OptionalDouble.empty();
    }
    return fields.edge("spacings", fields.three("spacings"), unit(fields, "units"));
  }

  /** Lengths of the steps from voxel to voxel along the three axes, at right angles. */
  private static double[] lengths(HeaderFields fields) throws ImageFileException {
    String name = "space directions";
    double[][] steps = new double[3][];
    Matcher vector = VECTOR.matcher(fields.get(name));
    int count = 0;
    try {
      for (; vector.find(); count++) {
        String[] words = vector.group(1).split(",");
        if (count < 3) {
          steps[count] = Arrays.stream(words).mapToDouble(Double::parseDouble).toArray();
        }
      }
    } catch (NumberFormatException e) {
      throw fields.wrong("field must be vectors of numbers", name);
    }
    if (count != 3 || steps[0].length != steps[1].length || steps[0].length != steps[2].length) {
      throw fields.wrong("field must be 3 vectors, one for each axis", name);
    }
    double[] lengths = new double[3];
    for (int i = 0; i < 3; i++) {
      lengths[i] = Math.sqrt(dot(steps[i], steps[i]));
    }
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      if (Math.abs(dot(steps[i], steps[j])) > RIGHT_ANGLE * lengths[i] * lengths[j]) {
        throw fields.wrong("axes must be at right angles (resample the image)", name);
      }
    }
    return lengths;
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  /** The unit of all axes, if it is stated and one. */
  private static Optional<String> unit(HeaderFields fields, String name) {
    Matcher quoted = QUOTED.matcher(fields.find(name).orElse(""));
    Optional<String> unit = Optional.empty();
    while (quoted.find()) {
      if (unit.isPresent() && !unit.get().equals(quoted.group(1).strip())) {
        return Optional.empty();
      }
      unit = Optional.of(quoted.group(1).strip());
    }
    return unit;
  }
}
