package org.hdispatch.app.permeability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.hdispatch.app.Cli;
import org.hdispatch.app.RawFile;
import org.hdispatch.app.draw.ColourMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class InspectCommandTest {
  @TempDir Path folder;

  /** A tube along z in solid, and a pore on its own in the middle plane across x. */
  private Path tubeAndIsolatedPore() {
    return RawFile.write(
        folder, 8, 6, 4, (x, y, z) -> x == 4 && y == 1 || x == 4 && y == 4 && z == 2);
  }

  @Test
  void tellsLabelsPorosityAndWhatSpansEachAxis() {
    Map<String, String> json = Cli.json("inspect", tubeAndIsolatedPore(), "--dims=8,6,4", "--json");
    assertEquals("192", json.get("file_bytes"));
    assertEquals("192", json.get("image_bytes"));
    assertEquals("187", json.get("label_0"));
    assertEquals("5", json.get("label_1"));
    assertEquals(
        List.of("label_0", "label_1"),
        json.keySet().stream().filter(k -> k.startsWith("label")).toList());
    assertEquals(Double.toString(5 / 192.0), json.get("porosity"));
    assertEquals("false", json.get("percolates_x"));
    assertEquals("false", json.get("percolates_y"));
    assertEquals("true", json.get("percolates_z"));
    assertEquals(Double.toString(4 / 192.0), json.get("porosity_connected_z"));
    assertEquals("1", json.get("isolated_pore_voxels_z"));
    assertEquals("null", json.get("voxel_edge_m"));
  }

  @Test
  void picturesTellIsolatedPoresFromOthers() throws IOException {
    Path result = folder.resolve("result");
    Cli run = Cli.run("inspect", tubeAndIsolatedPore(), "--dims=8,6,4", "--output=" + result);
    assertEquals(0, run.code(), run.err());
    BufferedImage plane = ImageIO.read(result.resolve("slice-x.png").toFile());
    int pixels = plane.getWidth() / 6; // across x: y to the right, z downwards
    assertEquals(4 * pixels, plane.getHeight());
    assertEquals(0xff000000 | ColourMap.PORE, plane.getRGB(1 * pixels, 0));
    assertEquals(0xff000000 | ColourMap.ISOLATED, plane.getRGB(4 * pixels, 2 * pixels));
    assertEquals(0xff000000 | ColourMap.SOLID, plane.getRGB(4 * pixels, 0));
  }

  @Test
  void solidImageIsDescribedToo() {
    Path image = RawFile.write(folder, 4, 4, 4, (x, y, z) -> false);
    Cli run = Cli.run("inspect", image, "--dims=4,4,4");
    assertEquals(0, run.code(), run.err());
    assertTrue(run.out().contains("does NOT percolate: k = 0"), run.out());
  }

  @Test
  void hdf5TellsItsDatasets() {
    Path file = Path.of("../porous/src/test/resources/hdf5-compat/ok_gzip.h5");
    Map<String, String> json = Cli.json("inspect", file, "--json");
    assertEquals("\"HDF5\"", json.get("format"));
    assertTrue(json.get("datasets").contains(json.get("dataset").replace("\"", "")));
    assertEquals("\"[48, 40, 40]\"", json.get("shape"));
  }

  @Test
  void bundledRockIsThatOfTheNotice() {
    Map<String, String> json = Cli.json("inspect", "--json");
    assertEquals("50343", json.get("label_1"));
    for (String axis : List.of("x", "y", "z")) {
      assertEquals("true", json.get("percolates_" + axis));
    }
  }
}
