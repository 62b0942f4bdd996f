package org.hdispatch.porous.io;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Writes VTI files: image data that ParaView opens, with arrays per voxel.
 *
 * <p>Format: VTK XML ImageData 1.0, little-endian, cell data, raw appended data with UInt64 lengths
 * (VTK file formats, "XML file formats"). The values are streamed through a buffer of 1 MiB.
 */
public final class VtiWriter {
  private static final int BUFFER_BYTES = 1 << 20;

  private VtiWriter() {}

  /**
   * Writes a file; it is either whole or not there.
   *
   * @param target where it goes, by convention {@code *.vti}; its folder must exist
   * @param grid size, spacing and origin
   * @param arrays what is drawn, each with one value per voxel of the grid
   * @throws ImageFileException if it cannot be written; nothing is left behind
   * @throws IllegalArgumentException if an array has another size than the grid, or two have the
   *     same name
   */
  public static void write(Path target, VtiGrid grid, List<VtiArray> arrays)
      throws ImageFileException {
    Set<String> names = new HashSet<>();
    for (VtiArray array : arrays) {
      if (array.voxels() != grid.voxels()) {
        throw new IllegalArgumentException(
            "array must have one value per voxel: array="
                + array.name()
                + ", values="
                + array.voxels()
                + ", voxels="
                + grid.voxels());
      }
      if (!names.add(array.name())) {
        throw new IllegalArgumentException(
            "arrays must have different names: array=" + array.name());
      }
    }
    byte[] header = header(grid, arrays).getBytes(StandardCharsets.UTF_8);
    WholeFiles.write(
        target,
        channel -> {
          drain(channel, ByteBuffer.wrap(header));
          ByteBuffer buffer = ByteBuffer.allocate(BUFFER_BYTES).order(ByteOrder.LITTLE_ENDIAN);
          for (VtiArray array : arrays) {
            buffer.putLong(array.bytes());
            append(channel, buffer, array);
          }
          buffer.put("\n</AppendedData>\n</VTKFile>\n".getBytes(StandardCharsets.US_ASCII));
          flush(channel, buffer);
        });
  }

  private static String header(VtiGrid grid, List<VtiArray> arrays) {
    String extent = "0 " + grid.nx() + " 0 " + grid.ny() + " 0 " + grid.nz();
    String origin = grid.originX() + " " + grid.originY() + " " + grid.originZ();
    String spacing = grid.spacing() + " " + grid.spacing() + " " + grid.spacing();
    StringBuilder xml = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    xml.append("<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\"")
        .append(" header_type=\"UInt64\">\n")
        .append("<ImageData WholeExtent=\"" + extent + "\" Origin=\"" + origin + "\"")
        .append(" Spacing=\"" + spacing + "\">\n")
        .append("<Piece Extent=\"" + extent + "\">\n<PointData/>\n<CellData>\n");
    long offset = 0;
    for (VtiArray array : arrays) {
      xml.append("<DataArray type=\"" + array.type().vtkName() + "\"")
          .append(" Name=\"" + escape(array.name()) + "\"")
          .append(" NumberOfComponents=\"" + array.components() + "\"")
          .append(" format=\"appended\" offset=\"" + offset + "\"/>\n");
      offset += Long.BYTES + array.bytes();
    }
    // Offsets count from the byte after the underscore.
    return xml.append("</CellData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_")
        .toString();
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
    boolean labels = array.type() == VtiArray.Type.UINT8;
    int voxelBytes = components * array.type().bytes();
    for (int voxel = 0; voxel < array.voxels(); voxel++) {
      if (buffer.remaining() < voxelBytes) {
        flush(channel, buffer);
      }
      for (int c = 0; c < components; c++) {
        double value = values.at(voxel, c);
        if (labels) {
          buffer.put((byte) (int) value);
        } else {
          buffer.putFloat((float) value);
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
