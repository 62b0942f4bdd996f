package org.hdispatch.app.particles;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.hdispatch.app.Cli;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.sph.Particles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SearchStudyCommandTest {
  /** The keys that programs rely on, in their order. */
  private static final String KEYS =
      "search,threads,cell_edge,particle_steps_per_s,neighbours_mean,speed_up,efficiency,"
          + "bytes_per_particle,bytes_per_step,search_share,density_share,force_share,rebuilds,";

  private static final String SMALL = "--steps=2 --warm-up=1 --rounds=2 ";
  private static final String ROCK = SMALL + "--box=0,0,0,24,24,24 ";

  @TempDir Path folder;

  private static Cli study(String words) {
    List<String> command = new ArrayList<>(List.of("search-study"));
    command.addAll(List.of(words.split(" +")));
    return Cli.run(command.toArray());
  }

  private static List<String[]> rows(Cli run) {
    assertEquals(0, run.code(), run.err());
    assertEquals("", run.err());
    return run.out().lines().map(line -> line.split(",", -1)).toList();
  }

  @Test
  void everySearchRunsWithEveryEdgeAndNumberOfThreads() {
    Cli run = study(ROCK + "--threads=2 --cell-edges=3.3,6 --csv");
    List<String[]> rows = rows(run);
    assertTrue(run.out().startsWith(KEYS), run.out());
    assertEquals(1 + 3 * 2 * 2, rows.size());
    TreeSet<String> runs = new TreeSet<>();
    for (String[] row : rows.subList(1, rows.size())) {
      runs.add(row[0] + row[1] + row[2]);
      assertEquals(rows.get(1)[4], row[4], "all find the same neighbours");
      double efficiency = Double.parseDouble(row[5]) / Double.parseDouble(row[1]);
      assertEquals(efficiency, Double.parseDouble(row[6]), 1e-9);
    }
    assertEquals(12, runs.size());
    assertTrue(runs.contains("verlet26.0") && runs.contains("double16.0"), runs.toString());
  }

  @Test
  void boxTakesThePlaceOfTheRock() {
    Cli run = study(SMALL + "--periodic=512 --threads=1 --cell-edges=4");
    assertEquals(0, run.code(), run.err());
    for (String word :
        List.of(
            "shear flow in a periodic box of 8^3", "512, of which 512 fluid", "2 rounds of 2")) {
      assertTrue(run.out().contains(word), () -> word + " <- " + run.out());
    }
  }

  @Test
  void filesHoldTheFiguresAndThePlots() throws Exception {
    Path result = folder.resolve("result");
    Cli run = study(ROCK + "--threads=2 --cell-edges=3.3,6 --output=" + result);
    assertEquals(0, run.code(), run.err());
    try (Stream<Path> files = Files.list(result)) {
      assertEquals(
          new TreeSet<>(List.of("search.csv", "search.json", "speed-up.svg", "cell-edge.svg")),
          new TreeSet<>(files.map(file -> file.getFileName().toString()).toList()));
    }
    for (String plot : List.of("speed-up.svg", "cell-edge.svg")) {
      var svg =
          DocumentBuilderFactory.newInstance()
              .newDocumentBuilder()
              .parse(result.resolve(plot).toFile());
      assertEquals(3 * 2, svg.getElementsByTagName("circle").getLength(), plot);
    }
  }

  /** A pore of 2 x 2 x 2 in 6 x 6 x 6, which is at its corner; the image's is beside it. */
  @Test
  void rockIsContinuedByItsMirrorImages() {
    PoreSpace corner = PoreSpace.of(6, 6, 6, (x, y, z) -> Math.max(x, Math.max(y, z)) < 2);
    Particles particles = new RockFlow(corner, new int[] {2, 1, 1}).particles();
    int fluid = 0;
    for (int n = 0; n < particles.count(); n++) {
      if (particles.phase(n) == 0) {
        fluid++;
        assertTrue(particles.x(n) < 2.1 || particles.x(n) > 9.9, () -> "both ends");
      }
    }
    assertEquals(16, fluid);
  }

  @Test
  void imagesAreAddedAxisByAxisUntilThereAreEnough() {
    assertArrayEquals(new int[] {1, 1, 1}, RockFlow.repeats(100, 100));
    assertArrayEquals(new int[] {2, 1, 1}, RockFlow.repeats(100, 101));
    assertArrayEquals(new int[] {2, 2, 2}, RockFlow.repeats(100, 800));
    assertArrayEquals(new int[] {3, 2, 2}, RockFlow.repeats(100, 801));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--cell-edges=3.2",
        "--cell-edges=,",
        "--cell-edges=NaN",
        "--rounds=0",
        "--steps=0",
        "--warm-up=0",
        "--threads=0",
        "--particles=0",
        "--periodic=1001",
        "--periodic=512 --particles=600",
        "--periodic=512 --pore-value=1",
        "--box=0,0,0,5,64,64",
        "--box=0,0,0,65,64,64",
        "--json --csv"
      })
  void wrongArgumentsAreRefused(String words) {
    study(words).assertRefused(2);
  }

  @Test
  void refusalsNameTheValue() {
    study("--periodic=512 --cell-edges=3.2")
        .assertRefused(2, "cell edge must be at least the support radius and the skin: edge=3.2");
    study("none.raw --dims=2,2,2").assertRefused(3, "none.raw");
  }
}
