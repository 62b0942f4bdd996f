package org.hdispatch.app.particles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.hdispatch.app.Cli;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.draw.ColourMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class SphCaseCommandTest {
  @TempDir Path folder;

  /** The first steps; that flows are right is for the tests of the cases. */
  @ParameterizedTest
  @EnumSource(ReadyCase.class)
  void everyCaseSaysWhatIsFoundAndKnown(ReadyCase each) {
    String name = Choices.word(each);
    double step = 1e-6 * each.flow(each.usualSize()).duration();
    Map<String, String> json = Cli.json("sph", name, "--time", step, "--json");
    List<String> keys = List.copyOf(json.keySet());
    assertEquals(List.of("case", "size", "time"), keys.subList(0, 3));
    assertEquals(keys.get(3) + "_known", keys.get(4));
    assertEquals(keys.get(3) + "_error", keys.get(5));
    assertTrue(keys.containsAll(SphPeriodicCommandTest.KEYS));
    assertEquals('"' + name + '"', json.get("case"));
    assertEquals(Integer.toString(each.usualSize()), json.get("size"));
    assertTrue(!json.get(keys.get(5)).equals("null"), json.toString());
  }

  /** The kernel's viscosity is 0.07 % too large. */
  @Test
  void flowIsComparedWithItsSeries() {
    Map<String, String> json = Cli.json("sph", "poiseuille", "--size=8", "--json");
    assertEquals(0, Double.parseDouble(json.get("velocity_deviation_error")), 1e-3);
    assertEquals(1.0, Double.parseDouble(json.get("time")), 1e-3);
    Cli text = Cli.run("sph", "couette", "--size=8", "--time=0.01");
    assertEquals(0, text.code(), text.err());
    assertTrue(text.out().contains("mean velocity"), text.out());
    assertTrue(text.out().contains(", known "), text.out());
    assertTrue(text.out().contains("MPUPS"), text.out());
  }

  @Test
  void filesShowTheParticles() throws Exception {
    Path result = folder.resolve("result");
    Cli run = Cli.run("sph", "poiseuille", "--size=8", "--time=0.01", "--output", result);
    assertEquals(0, run.code(), run.err());
    try (Stream<Path> files = Files.list(result)) {
      assertEquals(
          new TreeSet<>(List.of("particles.png", "particles.vtp", "sph.json")),
          new TreeSet<>(files.map(file -> file.getFileName().toString()).toList()));
    }
    String vtp =
        Files.readString(
            result.resolve("particles.vtp"), java.nio.charset.StandardCharsets.ISO_8859_1);
    assertTrue(vtp.contains("NumberOfPoints=\"160\""), vtp.substring(0, 300)); // 10 x (8 + 2 x 4)
    for (String name : List.of("id", "phase", "velocity", "density", "pressure")) {
      assertTrue(vtp.contains("Name=\"" + name + "\""), name);
    }
    BufferedImage picture = ImageIO.read(result.resolve("particles.png").toFile());
    assertEquals(960, picture.getHeight(), 1);
    int solid = 0;
    int fluid = 0;
    for (int y = 0; y < picture.getHeight(); y++) {
      int rgb = picture.getRGB(picture.getWidth() / 2 + 20, y) & 0xffffff;
      solid += rgb == ColourMap.SOLID ? 1 : 0;
      fluid += rgb != ColourMap.SOLID && rgb != 0xffffff ? 1 : 0;
    }
    assertTrue(solid > 200 && fluid > 200, () -> "fluid and solid in the middle column");
  }

  @Test
  void unwritableFolderIsRefusedBeforeAnythingRuns() throws Exception {
    Path file = Files.writeString(folder.resolve("file"), "");
    Cli.run("sph", "poiseuille", "--output", file).assertRefused(3, "output must be a folder");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"--size=3", "--size=x", "--time=0", "--time=-1", "--time=NaN", "--cell-edge=2"})
  void wrongArgumentsAreRefused(String word) {
    Cli.run("sph", "poiseuille", word).assertRefused(2);
  }

  /** Before any site is looked at: there are 10^15 of them. */
  @Test
  void sitesThatDoNotFitAreRefusedAtOnce() {
    Cli.run("sph", "spheres", "--size=100000")
        .assertRefused(5, "heap must hold 99", "particles: needed=");
  }

  @Test
  void particlesThatDoNotFitAreRefusedWithTheHeapThatIsNeeded() {
    Host small = new Host(64L << 20, false);
    Cli.run(small, "sph", "periodic").assertRefused(5, "heap must hold 216000 particles", "-Xmx");
  }
}
