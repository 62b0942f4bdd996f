package org.hdispatch.porous.io;

import java.nio.file.Path;
import java.util.List;

/**
 * Writes VTP files: points that ParaView opens, such as particles, with arrays per point.
 *
 * <p>Format: VTK XML PolyData 1.0, little-endian, a vertex at each point, point data, raw appended
 * data with UInt64 lengths (VTK file formats, "XML file formats"). The values are streamed through
 * a buffer of 1 MiB.
 */
public final class VtpWriter {
  private VtpWriter() {}

  /**
   * Writes a file; it is either whole or not there.
   *
   * @param target where it goes, by convention {@code *.vtp}; its folder must exist
   * @param points where the points lie: a vector each; its name is not kept
   * @param arrays what is drawn, each with one value per point
   * @throws ImageFileException if it cannot be written; nothing is left behind
   * @throws IllegalArgumentException if the points are no vectors, an array has not one value per
   *     point, or two have the same name
   */
  public static void write(Path target, VtiArray points, List<VtiArray> arrays)
      throws ImageFileException {
    if (points.components() != 3) {
      throw new IllegalArgumentException(
          "points must have 3 components: components=" + points.components());
    }
    int count = points.voxels();
    AppendedData.requireAlike(arrays, "point", count);
    VtiArray vertices = VtiArray.integers("connectivity", count, (n, c) -> n);
    VtiArray ends = VtiArray.integers("offsets", count, (n, c) -> n + 1);
    AppendedData data = new AppendedData();
    data.write(
        target,
        AppendedData.XML
            + "\"PolyData\""
            + AppendedData.FORM
            + ("<PolyData>\n<Piece NumberOfPoints=\"" + count + "\"")
            + (" NumberOfVerts=\"" + count + "\" NumberOfLines=\"0\"")
            + " NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n"
            + data.declare(arrays)
            + "</PointData>\n<CellData/>\n<Points>\n"
            + data.declare(points)
            + "</Points>\n<Verts>\n"
            + data.declare(List.of(vertices, ends))
            + "</Verts>\n</Piece>\n</PolyData>\n");
  }
}
