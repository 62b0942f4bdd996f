package org.hdispatch.porous.io;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The arrays of a VTK XML file: declared in its header, appended raw behind it, little-endian, each
 * after its length as UInt64 (VTK file formats, "XML file formats"). The values are streamed
 * through a buffer of 1 MiB.
 */
final class AppendedData {
  /** Where every file begins, up to its type. */
  static final String XML = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<VTKFile type=";

  /** Attributes of a file with such data. */
  static final String FORM =
      " version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";

  private static final int BUFFER_BYTES = 1 << 20;

  private final List<VtiArray> arrays = new ArrayList<>();
  private long offset; // from the byte after the underscore

  /**
   * Checks arrays that lie side by side.
   *
   * @throws IllegalArgumentException if one has another number of values, or two have the same name
   */
  static void requireAlike(List<VtiArray> arrays, String what, int values) {
    Set<String> names = new HashSet<>();
    for (VtiArray array : arrays) {
      if (array.voxels() != values) {
        throw new IllegalArgumentException(
            "array must have one value per "
                + what
                + ": array="
                + array.name()
                + ", values="
                + array.voxels()
                + ", "
                + what
                + "s="
                + values);
      }
      if (!names.add(array.name())) {
        throw new IllegalArgumentException(
            "arrays must have different names: array=" + array.name());
      }
    }
  }

  /** Appends an array, and returns the element that declares it. */
  String declare(VtiArray array) {
    String element =
        "<DataArray type=\""
            + array.type().vtkName()
            + "\" Name=\""
            + escape(array.name())
            + "\" NumberOfComponents=\""
            + array.components()
            + "\" format=\"appended\" offset=\""
            + offset
            + "\"/>\n";
    arrays.add(array);
    offset += Long.BYTES + array.bytes();
    return element;
  }

  /** Appends several arrays, and returns the elements that declare them. */
  String declare(List<VtiArray> several) {
    StringBuilder elements = new StringBuilder();
    several.forEach(each -> elements.append(declare(each)));
    return elements.toString();
  }

  /**
   * Writes the file; it is either whole or not there.
   *
   * @param header all of the XML before the data
   * @throws ImageFileException if it cannot be written; nothing is left behind
   */
  void write(Path target, String header) throws ImageFileException {
    byte[] head = (header + "<AppendedData encoding=\"raw\">\n_").getBytes(StandardCharsets.UTF_8);
    WholeFiles.write(
        target,
        channel -> {
          drain(channel, ByteBuffer.wrap(head));
          ByteBuffer buffer = ByteBuffer.allocate(BUFFER_BYTES).order(ByteOrder.LITTLE_ENDIAN);
          for (VtiArray array : arrays) {
            buffer.putLong(array.bytes());
            append(channel, buffer, array);
          }
          buffer.put("\n</AppendedData>\n</VTKFile>\n".getBytes(StandardCharsets.US_ASCII));
          flush(channel, buffer);
        });
  }

  private static String escape(String name) {
    return name.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }

  private static void append(FileChannel channel, ByteBuffer buffer, VtiArray array)
      throws IOException {
    VtiArray.Values values = array.values();
    int components = array.components();
    int bytes = components * array.type().bytes();
    for (int n = 0; n < array.voxels(); n++) {
      if (buffer.remaining() < bytes) {
        flush(channel, buffer);
      }
      for (int c = 0; c < components; c++) {
        double value = values.at(n, c);
        switch (array.type()) {
          case UINT8 -> buffer.put((byte) (int) value);
          case INT32 -> buffer.putInt((int) value);
          case FLOAT32 -> buffer.putFloat((float) value);
        }
      }
    }
    flush(channel, buffer);
  }

  private static void flush(FileChannel channel, ByteBuffer buffer) throws IOException {
    buffer.flip();
    drain(channel, buffer);
    buffer.clear();
  }

  private static void drain(FileChannel channel, ByteBuffer buffer) throws IOException {
    while (buffer.hasRemaining()) {
      channel.write(buffer);
    }
  }
}
