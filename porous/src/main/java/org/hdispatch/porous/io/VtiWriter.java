package org.hdispatch.porous.io;

import java.nio.file.Path;
import java.util.List;

/**
 * Writes VTI files: image data that ParaView opens, with arrays per voxel.
 *
 * <p>Format: VTK XML ImageData 1.0, little-endian, cell data, raw appended data with UInt64 lengths
 * (VTK file formats, "XML file formats"). The values are streamed through a buffer of 1 MiB.
 */
public final class VtiWriter {
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
    AppendedData.requireAlike(arrays, "voxel", grid.voxels());
    String extent = "0 " + grid.nx() + " 0 " + grid.ny() + " 0 " + grid.nz();
    String origin = grid.originX() + " " + grid.originY() + " " + grid.originZ();
    String spacing = grid.spacing() + " " + grid.spacing() + " " + grid.spacing();
    AppendedData data = new AppendedData();
    data.write(
        target,
        AppendedData.XML
            + "\"ImageData\""
            + AppendedData.FORM
            + ("<ImageData WholeExtent=\"" + extent + "\" Origin=\"" + origin + "\"")
            + (" Spacing=\"" + spacing + "\">\n<Piece Extent=\"" + extent + "\">\n")
            + "<PointData/>\n<CellData>\n"
            + data.declare(arrays)
            + "</CellData>\n</Piece>\n</ImageData>\n");
  }
}
