package org.hdispatch.porous.io;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hdispatch.porous.image.VoxelBox;

/**
 * NumPy arrays in {@code .npy} files, format versions 1 to 3 (NumPy Enhancement Proposal 1): 3
 * dimensions (z, y, x), booleans or integers of any width and byte order whose values are within
 * 0..255, in C or Fortran order.
 *
 * <p>They state no voxel edge. Archives ({@code .npz}) are not read.
 */
public final class NumpyImages {
  private static final byte[] MAGIC = {(byte) 0x93, 'N', 'U', 'M', 'P', 'Y'};
  private static final int MOST_HEADER_BYTES = 1 << 16;

  private static final Pattern TYPE = Pattern.compile("'descr'\\s*:\\s*([^,}]*)");
  private static final Pattern ORDER = Pattern.compile("'fortran_order'\\s*:\\s*(True|False)");
  private static final Pattern SHAPE = Pattern.compile("'shape'\\s*:\\s*\\(([\\d\\s,]*)\\)");
  private static final Pattern INTEGER = Pattern.compile("'([<>|])([bui])([1248])'");

  private NumpyImages() {}

  /** Whether a file begins like this. */
  static boolean isStart(byte[] start) {
    return Arrays.equals(MAGIC, Arrays.copyOf(start, MAGIC.length));
  }

  /**
   * The array in a file.
   *
   * @param file a file in NumPy's format
   * @return the image, its voxel edge unknown
   * @throws ImageFileException if the file is missing, not in NumPy's format or of another length
   *     than its header says, or if the array has no 3 dimensions or no integers
   */
  public static ImageFile open(Path file) throws ImageFileException {
    ImageFiles.requireReadable(file);
    try (InputStream in = Files.newInputStream(file)) {
      byte[] start = in.readNBytes(MAGIC.length + 2);
      if (!isStart(start) || start.length < MAGIC.length + 2) {
        throw new ImageFileException("file must be in NumPy's format (.npy): file=" + file);
      }
      int version = start[MAGIC.length];
      if (version < 1 || version > 3) {
        throw new ImageFileException(
            "format version must be 1 to 3 (write it again: numpy.save): file="
                + file
                + ", version="
                + version);
      }
      byte[] length = in.readNBytes(version == 1 ? 2 : 4);
      long bytes = 0;
      for (int i = length.length - 1; i >= 0; i--) {
        bytes = bytes << 8 | length[i] & 0xff;
      }
      if (bytes > MOST_HEADER_BYTES) {
        throw new ImageFileException(
            "header must have at most "
                + MOST_HEADER_BYTES
                + " bytes: file="
                + file
                + ", header="
                + bytes
                + " bytes");
      }
      byte[] header = in.readNBytes((int) bytes);
      if (header.length < bytes) {
        throw new EOFException("in the header");
      }
      String text = new String(header, StandardCharsets.UTF_8).replace('"', '\'').strip();
      return image(file, start.length + length.length + bytes, text);
    } catch (ImageFileException e) {
      throw e;
    } catch (IOException e) {
      throw ImageFiles.unreadable(file, e);
    }
  }

  private static ImageFile image(Path file, long start, String header) throws ImageFileException {
    Matcher typeField = TYPE.matcher(header);
    Matcher orderField = ORDER.matcher(header);
    Matcher shapeField = SHAPE.matcher(header);
    if (!typeField.find() || !orderField.find() || !shapeField.find()) {
      throw new ImageFileException(
          "header must have 'descr', 'fortran_order' and 'shape': file="
              + file
              + ", header="
              + header);
    }
    LabelType type = labelType(file, typeField.group(1).strip());
    boolean fortran = orderField.group(1).equals("True");
    String shape = "(" + shapeField.group(1).strip() + ")";
    String[] lengths = shapeField.group(1).replaceAll("\\s", "").split(",");
    if (lengths.length != 3) {
      throw new ImageFileException(
          "array must have 3 dimensions (z, y, x): file=" + file + ", shape=" + shape);
    }
    int[] n = new int[3]; // as the file runs: the fastest first
    for (int i = 0; i < 3; i++) {
      String length = lengths[fortran ? i : 2 - i];
      if (!length.matches("[1-9]\\d{0,9}") || Long.parseLong(length) > Integer.MAX_VALUE) {
        throw new ImageFileException(
            "dimensions must be 1 to " + Integer.MAX_VALUE + ": file=" + file + ", shape=" + shape);
      }
      n[i] = Integer.parseInt(length);
    }
    FlatVolume volume =
        new FlatVolume(
            file, start, FlatVolume.Packing.PLAIN, type, VoxelBox.whole(n[0], n[1], n[2]));
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("type", type.toString());
    facts.put("shape", shape);
    facts.put("order", fortran ? "Fortran" : "C");
    return FlatImage.of(
        ImageFormat.NUMPY.toString(),
        file,
        volume,
        fortran ? FlatImage.Order.Z_FASTEST : FlatImage.Order.X_FASTEST,
        OptionalDouble.empty(),
        facts);
  }

  private static LabelType labelType(Path file, String descr) throws ImageFileException {
    Matcher integer = INTEGER.matcher(descr);
    boolean known =
        integer.matches()
            && (integer.group(3).equals("1")
                || !integer.group(1).equals("|") && !integer.group(2).equals("b"));
    if (!known) {
      throw new ImageFileException(
          "labels must be booleans or integers of 0..255 (convert them: a.astype('uint8')): file="
              + file
              + ", descr="
              + descr);
    }
    return new LabelType(
        Integer.parseInt(integer.group(3)),
        integer.group(2).equals("i"),
        integer.group(1).equals(">") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
  }
}
