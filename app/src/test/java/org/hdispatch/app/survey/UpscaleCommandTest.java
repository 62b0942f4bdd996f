package org.hdispatch.app.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.hdispatch.app.Cli;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UpscaleCommandTest {
  @TempDir Path folder;

  /** Blocks of 8³, two along x: a wide and a narrow duct along z; solid behind, and outside (9). */
  private Path image() throws IOException {
    byte[] labels = new byte[16 * 16 * 8];
    for (int n = 0; n < labels.length; n++) {
      int x = n % 16;
      int y = n / 16 % 16;
      boolean wide = x < 6 && y < 6;
      boolean narrow = x >= 10 && x < 14 && y >= 2 && y < 6;
      labels[n] = (byte) (x >= 8 && y >= 8 ? 9 : wide || narrow ? 1 : 0);
    }
    return Files.write(folder.resolve("ducts.raw"), labels);
  }

  private Path survey(String... more) throws IOException {
    Path to = folder.resolve("survey");
    List<Object> all =
        new ArrayList<>(
            List.of(
                "survey",
                image(),
                "--dims=16,16,8",
                "--block=8",
                "--voxel-edge=1e-6",
                "--threads=1",
                "--quiet",
                "--output=" + to));
    all.addAll(List.of(more));
    Cli.run(all.toArray());
    return to;
  }

  private static List<Double> permeabilities(Path survey, String axis) throws IOException {
    return SurveyCommandTest.rows(survey.resolve("survey.csv")).stream()
        .filter(row -> row.get("axis").equals(axis) && !row.get("permeability_mD").isEmpty())
        .map(row -> Double.valueOf(row.get("permeability_mD")))
        .toList();
  }

  @Test
  void ductsSideBySideGiveTheMeanOfTheBlocksThatAreThere() throws IOException {
    Path survey = survey("--axis=all", "--outside-value=9");
    List<Double> blocks = permeabilities(survey, "z");
    assertEquals(3, blocks.size());
    double mean = (blocks.get(0) + blocks.get(1) + blocks.get(2)) / 3; // solid counts, outside not
    Path out = folder.resolve("out");
    Cli run = Cli.run("upscale", survey, "--threads=1", "--output=" + out);
    assertEquals(0, run.code(), run.err());
    assertEquals("", run.err());
    for (String part :
        List.of(
            "3 of 8,8,8 voxels, in 2 x 2 x 1 places",
            "outside              1 places: nothing flows there",
            "0 mD, NO way leads through",
            "1 blocks do not percolate: k = 0",
            "harmonic 0, arithmetic")) {
      assertTrue(run.out().contains(part), () -> part + " <- " + run.out());
    }
    List<Map<String, String>> rows = SurveyCommandTest.rows(out.resolve("upscale.csv"));
    assertEquals(List.of("x", "y", "z"), rows.stream().map(row -> row.get("axis")).toList());
    Map<String, String> z = rows.get(2);
    assertEquals(mean, Double.parseDouble(z.get("permeability_mD")), 1e-9 * mean);
    for (String bound : List.of("columns_mD", "layers_mD", "arithmetic_mD")) {
      assertEquals(mean, Double.parseDouble(z.get(bound)), 1e-12 * mean);
    }
    assertEquals("0.0", z.get("harmonic_mD"));
    assertEquals("0.0", rows.get(0).get("permeability_mD"));
    assertEquals("false", rows.get(0).get("percolates"));
    assertEquals("1", z.get("outside"));
    assertEquals("0", z.get("left_out"));
    assertEquals("wall", z.get("sides"));
    assertEquals(
        Files.readString(out.resolve("upscale.json")), Cli.run("upscale", survey, "--json").out());
    assertEquals(
        Files.readString(out.resolve("upscale.csv")),
        Cli.run("upscale", survey, "--csv", "--threads=2").out());
  }

  @Test
  void blocksThatWereLeftOutAreSaid() throws IOException {
    Path survey = survey("--axis=all", "--blocks=0-2");
    Cli run = Cli.run("upscale", survey);
    assertEquals(0, run.code(), run.err());
    assertTrue(run.out().contains("left out             1 places: not surveyed"), run.out());
  }

  @Test
  void oneAxisGivesBoundsAlone() throws IOException {
    Path survey = survey("--blocks=0,1");
    Cli run = Cli.run("upscale", survey);
    assertEquals(0, run.code(), run.err());
    assertTrue(run.out().contains("only bounds: blocks must be surveyed along all"), run.out());
    assertFalse(run.out().contains("along x"), run.out());
    String json = Cli.run("upscale", survey, "--json").out();
    assertTrue(json.contains("\"permeability_mD\": null,"), json);
    List<Double> blocks = permeabilities(survey, "z");
    assertTrue(json.contains("\"columns_mD\": "), json);
    Files.writeString(folder.resolve("rows.csv"), Cli.run("upscale", survey, "--csv").out());
    double mean = (blocks.get(0) + blocks.get(1)) / 2;
    Map<String, String> row = SurveyCommandTest.rows(folder.resolve("rows.csv")).get(0);
    assertEquals(mean, Double.parseDouble(row.get("columns_mD")), 1e-12 * mean);
  }

  @Test
  void blocksThatDidNotConvergeAreTakenAndSaid() throws IOException {
    Path survey = survey("--axis=all", "--blocks=0,1", "--max-steps=10");
    Cli run = Cli.run("upscale", survey);
    assertEquals(4, run.code(), run.err());
    assertTrue(run.out().contains("2 blocks did NOT CONVERGE"), run.out());
    assertTrue(run.err().contains("every permeability must have converged"), run.err());
  }

  @Test
  void refusesWhatIsNoMapOfBlocks() throws IOException {
    Cli.run("upscale", folder).assertRefused(3, "folder must hold a survey");
    Path survey = survey("--axis=all", "--blocks=0,1");
    Path table = survey.resolve("survey.csv");
    List<String> lines = Files.readAllLines(table);
    Files.write(table, lines.subList(0, 4));
    Cli.run("upscale", survey).assertRefused(3, "rows of all jobs must be there", "rows=3 of 6");
    lines.replaceAll(line -> line.replace("does-not-percolate,", "failed,why"));
    Files.write(table, lines);
    Cli.run("upscale", survey)
        .assertRefused(3, "every block must have a permeability", "cause=why");
    Cli.run("upscale").assertRefused(2, "missing required parameter");
  }

  @Test
  void refusesBlocksThatOverlap() throws IOException {
    Path survey = survey("--stride=4");
    Cli.run("upscale", survey).assertRefused(3, "blocks must lie side by side");
  }
}
