package org.hdispatch.porous.io;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.VoxelBox;

/**
 * MetaImage files (MetaIO, as ITK and VTK write them): the header in front of the voxels ({@code
 * .mha}) or in a file of its own ({@code .mhd}), 3 dimensions, the first being x, integers whose
 * values are within 0..255, plain or compressed (zlib or gzip).
 *
 * <p>The voxel edge is {@code ElementSpacing} or else {@code ElementSize}, in {@code DistanceUnits}
 * (um, mm, cm) or else in millimetres, as MetaIO's {@code metaImage.h} says. Spacings of 1 without
 * a unit are taken for unknown: that is what programs write that know none. Voxels must be cubes.
 * Where the byte order is not stated it is little-endian, that of today's machines.
 */
public final class MetaImages {
  private static final String DATA_FILE = "ElementDataFile";
  private static final String SIZE = "DimSize";
  private static final String TYPE = "ElementType";
  private static final String HEADER_SIZE = "HeaderSize";
  private static final String UNIT = "DistanceUnits";
  private static final String MOST_SIGNIFICANT_FIRST = "BinaryDataByteOrderMSB";

  private MetaImages() {}

  /**
   * The image in a file.
   *
   * @param file a file in MetaImage format; the header, where it stands apart
   * @return the image, with its voxel edge where the header states it
   * @throws ImageFileException if a file is missing, not a MetaImage or of another length than its
   *     header says, or if the image has no 3 dimensions, no integers, no cubic voxels, or is
   *     stored in a way that is not read; the message names the remedy
   */
  public static ImageFile open(Path file) throws ImageFileException {
    HeaderText header = HeaderText.read(file, line -> line.matches(DATA_FILE + "\\s*=.*"));
    HeaderFields fields = fields(file, header);
    if (fields.integer("NDims", 3) != 3) {
      throw fields.wrong("image must have 3 dimensions (x y z)", "NDims");
    }
    VoxelBox whole = fields.size(SIZE);
    LabelType type = labelType(fields);
    if (fields.integer("ElementNumberOfChannels", 1) != 1) {
      throw fields.wrong("voxels must have one channel", "ElementNumberOfChannels");
    }
    if (!fields.flag("BinaryData", true)) {
      throw fields.wrong("voxels must be binary (write it again as binary)", "BinaryData");
    }
    Path data = dataFile(file, fields);
    boolean local = data.equals(file);
    long start = start(fields, data, local ? header.end().get() : 0, type);
    FlatVolume.Packing packing =
        fields.flag("CompressedData", false) ? packing(data, start) : FlatVolume.Packing.PLAIN;
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("type", type.toString());
    facts.put("compressed", packing != FlatVolume.Packing.PLAIN);
    if (!local) {
      facts.put("data_file", data.toString());
    }
    for (String field : new String[] {"ElementSpacing", "ElementSize", UNIT}) {
      fields.find(field).ifPresent(value -> facts.put(underscored(field), value));
    }
    return FlatImage.of(
        ImageFormat.META_IMAGE.toString(),
        file,
        new FlatVolume(data, start, packing, type, whole),
        FlatImage.Order.X_FASTEST,
        voxelEdge(fields),
        facts);
  }

  private static String underscored(String field) {
    return field.replaceAll("(?<=[a-z])(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
  }

  private static HeaderFields fields(Path file, HeaderText header) throws ImageFileException {
    HeaderFields fields = new HeaderFields(file);
    if (header.end().isEmpty()) {
      throw new ImageFileException(
          "file must be a MetaImage header that ends with " + DATA_FILE + ": file=" + file);
    }
    for (String line : header.lines()) {
      int equals = line.indexOf('=');
      if (equals < 0 && !line.isBlank()) {
        throw new ImageFileException(
            "header line must be 'Field = value': file=" + file + ", line=" + line);
      }
      if (equals >= 0) {
        fields.put(line.substring(0, equals).strip(), line.substring(equals + 1));
      }
    }
    return fields;
  }

  private static LabelType labelType(HeaderFields fields) throws ImageFileException {
    String name = fields.get(TYPE);
    int bytes =
        switch (name.replaceFirst("^MET_U?", "")) {
          case "CHAR" -> 1;
          case "SHORT" -> 2;
          case "INT", "LONG" -> 4; // metaTypes.h: MET_LONG has 4 bytes
          case "LONG_LONG" -> 8;
          default ->
              throw fields.wrong("labels must be integers of 0..255 (convert them to uint8)", TYPE);
        };
    boolean big = fields.flag(MOST_SIGNIFICANT_FIRST, fields.flag("ElementByteOrderMSB", false));
    return new LabelType(
        bytes,
        !name.startsWith("MET_U"),
        big && bytes > 1 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
  }

  private static Path dataFile(Path file, HeaderFields fields) throws ImageFileException {
    String name = fields.get(DATA_FILE);
    if (name.equals("LOCAL")) {
      return file;
    }
    if (name.isEmpty() || name.startsWith("LIST") || name.contains("%")) {
      throw fields.wrong("voxels must be LOCAL or in one data file (join its parts)", DATA_FILE);
    }
    return file.resolveSibling(name);
  }

  private static long start(HeaderFields fields, Path data, long header, LabelType type)
      throws ImageFileException {
    long skip = fields.integer(HEADER_SIZE, 0);
    boolean compressed = fields.flag("CompressedData", false);
    if (skip < -1 || skip == -1 && compressed) {
      throw fields.wrong("header size must be at least 0, or -1 where data is plain", HEADER_SIZE);
    }
    if (skip == -1) { // the voxels are what the file ends with
      return Math.max(
          header, ImageFiles.requireReadable(data) - FlatVolume.bytes(fields.size(SIZE), type));
    }
    return skip > 0 ? skip : header;
  }

  /** MetaIO takes both: by the first two bytes. */
  private static FlatVolume.Packing packing(Path data, long start) throws ImageFileException {
    ImageFiles.requireReadable(data);
    try (InputStream in = Files.newInputStream(data)) {
      in.skipNBytes(start);
      boolean gzip = Arrays.equals(in.readNBytes(2), new byte[] {0x1f, (byte) 0x8b});
      return gzip ? FlatVolume.Packing.GZIP : FlatVolume.Packing.ZLIB;
    } catch (IOException e) {
      throw ImageFiles.unreadable(data, e);
    }
  }

  private static OptionalDouble voxelEdge(HeaderFields fields) throws ImageFileException {
    String name = fields.find("ElementSpacing").isPresent() ? "ElementSpacing" : "ElementSize";
    if (fields.find(name).isEmpty()) {
      return OptionalDouble.empty();
    }
    double[] spacings = fields.three(name);
    Optional<String> unit = fields.find(UNIT);
    boolean nobodyKnew = unit.isEmpty() && Arrays.equals(spacings, new double[] {1, 1, 1});
    OptionalDouble edge = fields.edge(name, spacings, unit.or(() -> Optional.of("mm")));
    return nobodyKnew ? OptionalDouble.empty() : edge;
  }
}
