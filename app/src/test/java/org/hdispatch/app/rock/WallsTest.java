package org.hdispatch.app.rock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.hdispatch.app.Cli;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WallsTest {
  /** Zick and Homsy 1982: k = L²/(6 pi K r/L), K = 15.4 at 0.343. */
  @Test
  void immersedSpheresAreRightToAPercentOnFewVoxels() {
    Map<String, String> row =
        Cli.json("permeability", "--spheres", "sc", "--size", 16, "--walls", "imb", "--json");
    double exact = 16 * 16 / (6 * Math.PI * 15.4 * Math.cbrt(3 * 0.343 / (4 * Math.PI)));
    assertEquals(1, Double.parseDouble(row.get("permeability_voxel2")) / exact, 0.02);
    assertEquals("\"imb\"", row.get("walls"));
    assertEquals("\"D3Q15\"", row.get("lattice"));
    assertEquals("\"bgk\"", row.get("collision"));
    assertEquals("0.6", row.get("tau"));
    assertEquals(1 - 0.343, Double.parseDouble(row.get("porosity")), 1e-5);
    assertEquals(1 - 0.343, Double.parseDouble(row.get("porosity_connected")), 1e-5);
  }

  @Test
  void warnsWhereImmersedBoundariesAreNotRight() {
    Cli run = Cli.run("permeability", "--spheres", "sc", "--size", 8, "--walls", "imb", "--tau", 1);
    assertEquals(0, run.code(), run.err());
    assertTrue(run.err().contains("warning: immersed moving boundaries are right at"), run.err());
    assertTrue(run.out().contains("walls imb"), run.out());
  }

  @Test
  void greyValuesAreSolidFractions(@TempDir Path folder) throws IOException {
    byte[] grey = new byte[8 * 8 * 8];
    for (int voxel = 0; voxel < grey.length; voxel++) {
      int x = Math.min(voxel % 8, 7 - voxel % 8);
      grey[voxel] = (byte) (x == 0 ? 200 : x == 1 ? 125 : 50);
    }
    Path file = folder.resolve("slot.raw");
    Files.write(file, grey);
    Object[] image = {"permeability", file, "--dims", "8,8,8", "--voxel-edge", 1e-6};
    Cli segmented = run(image, "--pore-value", "50", "--walls", "imb", "--sides", "periodic");
    assertEquals(0, segmented.code(), segmented.err());
    assertTrue(segmented.err().contains("bring nothing to a segmented image"), segmented.err());
    Cli run =
        run(image, "--walls", "imb", "--solid-fraction-range", "50,200", "--sides", "periodic");
    assertEquals(0, run.code(), run.err());
    assertEquals("", run.err());
    assertTrue(run.out().contains("0.625"), run.out()); // porosity
    run(image, "--solid-fraction-range", "50,200").assertRefused(2, "must come with --walls imb");
    run(image, "--walls", "imb", "--solid-fraction-range", "5,5").assertRefused(2, "must differ");
    run(image, "--walls", "imb", "--solid-fraction-range", "5").assertRefused(2, "2 integers");
    run(image, "--walls", "imb", "--solid-fraction-range", "255,201")
        .assertRefused(3, "must have pore voxels", "pore_solid=255,201");
    run(image, "--walls", "brick").assertRefused(2, "bounce-back, imb");
  }

  private static Cli run(Object[] image, Object... more) {
    Object[] all = java.util.Arrays.copyOf(image, image.length + more.length);
    System.arraycopy(more, 0, all, image.length, more.length);
    return Cli.run(all);
  }
}
