package org.hdispatch.app.steady;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import org.hdispatch.app.Cli;
import org.hdispatch.app.RawFile;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.draw.StudyPageTest;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.pore.PoreSpace;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Document;

class SteadyStudyCommandTest {
  /** The keys that programs rely on, in their order. */
  private static final List<String> KEYS =
      List.of(
          "rock",
          "porosity",
          "approach",
          "permeability_voxel2",
          "permeability_mD",
          "steps_to_1_percent",
          "seconds_to_1_percent",
          "steps_ratio_to_1_percent",
          "seconds_ratio_to_1_percent",
          "steps_to_0_1_percent",
          "seconds_to_0_1_percent",
          "steps_ratio_to_0_1_percent",
          "seconds_ratio_to_0_1_percent",
          "stopped",
          "steps_at_stop",
          "seconds_at_stop",
          "seconds_pressure_at_stop",
          "k_error_estimate_at_stop",
          "k_error_at_stop");

  /** Two rocks that are done in a moment. */
  private static final String[] SMALL = {
    "steady-study", "--size=12", "--radius=3", "--threads=1", "--porosity=0.5,0.7"
  };

  @TempDir Path folder;

  private static Cli small(String... more) {
    List<String> all = new ArrayList<>(List.of(SMALL));
    all.addAll(List.of(more));
    return Cli.run(all.toArray());
  }

  /** Rows of CSV without quotes, by their keys. */
  private static List<TreeMap<String, String>> rows(String csv) {
    List<String> lines = csv.lines().toList();
    String[] keys = lines.get(0).split(",");
    List<TreeMap<String, String>> rows = new ArrayList<>();
    for (String line : lines.subList(1, lines.size())) {
      String[] values = line.split(",", -1);
      assertEquals(keys.length, values.length, line);
      TreeMap<String, String> row = new TreeMap<>();
      for (int n = 0; n < keys.length; n++) {
        row.put(keys[n], values[n]);
      }
      rows.add(row);
    }
    return rows;
  }

  @Test
  void rowsFollowBothApproachesToTheSameK() {
    Cli run = small("--csv");
    assertEquals(0, run.code(), run.err());
    assertEquals("", run.err());
    List<String> header = List.of(run.out().lines().findFirst().orElseThrow().split(","));
    assertEquals(KEYS, header.subList(0, KEYS.size()));
    List<TreeMap<String, String>> rows = rows(run.out());
    assertEquals(4, rows.size());
    for (int n = 0; n < rows.size(); n++) {
      TreeMap<String, String> row = rows.get(n);
      assertEquals(n % 2 == 0 ? "corrected" : "plain", row.get("approach"));
      assertEquals(n < 2 ? "0.5" : "0.7", row.get("spheres_porosity"));
      assertEquals("true", row.get("reference_converged"));
      assertEquals("true", row.get("stopped"));
      assertTrue(Double.parseDouble(row.get("k_error_at_end")) <= 1e-4, row.toString());
      double stop = Double.parseDouble(row.get("steps_at_stop"));
      assertTrue(stop <= Double.parseDouble(row.get("steps_run")), row.toString());
      double steps = Double.parseDouble(row.get("steps_to_0_1_percent"));
      assertTrue(steps >= Double.parseDouble(row.get("steps_to_1_percent")), row.toString());
      double corrected = Double.parseDouble(rows.get(n - n % 2).get("steps_to_0_1_percent"));
      assertEquals(steps / corrected, Double.parseDouble(row.get("steps_ratio_to_0_1_percent")));
    }
  }

  @Test
  void pageHasItsFiguresTablesAndData() throws Exception {
    Path result = folder.resolve("a/b");
    Cli run = small("--output=" + result);
    assertEquals(0, run.code(), run.err());
    try (Stream<Path> files = Files.list(result)) {
      assertEquals(
          new TreeSet<>(
              List.of(
                  "steady-study-curves.csv",
                  "steady-study.csv",
                  "steady-study.html",
                  "steady-study.json")),
          new TreeSet<>(files.map(file -> file.getFileName().toString()).toList()));
    }
    String html = Files.readString(result.resolve("steady-study.html"));
    Document page = StudyPageTest.parsed(html);
    assertEquals(2 + 2 * 2, page.getElementsByTagName("svg").getLength());
    assertEquals(2, page.getElementsByTagName("table").getLength());
    assertEquals(1 + 2 * 3 + 1 + 2 * 2, page.getElementsByTagName("tr").getLength());
    for (TreeMap<String, String> row : rows(Files.readString(result.resolve("steady-study.csv")))) {
      assertTrue(html.contains("<td>" + row.get("steps_to_0_1_percent") + "</td>"));
      assertTrue(html.contains("<td>" + row.get("steps_at_stop") + "</td>"));
    }
    String command = page.getElementsByTagName("pre").item(0).getTextContent();
    assertEquals("./hdispatch " + String.join(" ", SMALL) + " --output=" + result, command);
    List<TreeMap<String, String>> curves =
        rows(Files.readString(result.resolve("steady-study-curves.csv")));
    for (TreeMap<String, String> point : curves) {
      double seconds = Double.parseDouble(point.get("seconds"));
      double pressure = Double.parseDouble(point.get("seconds_pressure"));
      assertEquals(point.get("approach").equals("plain"), pressure == 0, point.toString());
      assertTrue(seconds > pressure, point.toString());
    }
    assertTrue(curves.size() > 4 * 4, "points: " + curves.size());
  }

  @Test
  void tableTellsTheVerdict() {
    Cli run = small();
    assertEquals(0, run.code(), run.err());
    for (String part :
        List.of("approach", "ratio", "true error", "Until k stays within 0.1 %", "both rocks")) {
      assertTrue(run.out().contains(part), () -> part + " <- " + run.out());
    }
    assertTrue(run.out().chars().allMatch(c -> c < 128));
  }

  @Test
  void imageIsStudiedBoxByBox() throws IOException {
    RawFile.write(folder, 12, 12, 12, (x, y, z) -> x % 4 != 0 && y % 6 != 0);
    Cli run =
        Cli.run(
            "steady-study",
            folder.resolve("image.raw"),
            "--dims=12,12,12",
            "--voxel-edge=1e-6",
            "--box=0,0,0,12,12,10",
            "--box=0,0,0,8,6,12",
            "--json",
            "--output=" + folder.resolve("result"));
    assertEquals(0, run.code(), run.err());
    List<String> boxes = run.out().lines().filter(line -> line.contains("\"box\"")).toList();
    assertEquals(4, boxes.size());
    assertTrue(boxes.get(0).contains("0,0,0,12,12,10"), boxes.toString());
    assertTrue(boxes.get(3).contains("0,0,0,8,6,12"), boxes.toString());
    assertFalse(run.out().contains("\"permeability_mD\": null"), run.out());
    String page = Files.readString(folder.resolve("result/steady-study.html"));
    assertTrue(page.contains("0,0,0,8,6,12"));
    assertFalse(page.contains("random spheres"));
  }

  @Test
  void rockThatDoesNotPercolateIsLeftOut() {
    Cli run = small("--porosity=0.05", "--csv");
    assertEquals(0, run.code(), run.err());
    assertEquals(4, rows(run.out()).size());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().startsWith("hdispatch: warning: rock must percolate"), run.err());
    Cli none =
        Cli.run(
            "steady-study",
            "--size=12",
            "--porosity=0.05",
            "--quiet",
            "--output=" + folder.resolve("result"));
    none.assertRefused(2, "a rock must percolate: rocks=1");
    assertFalse(Files.exists(folder.resolve("result")));
  }

  @Test
  void steadyValueThatIsNotReachedIsSaid() {
    Cli run = small("--max-steps=60");
    assertEquals(4, run.code(), run.err());
    assertTrue(run.err().startsWith("hdispatch: steady k must be known"), run.err());
    assertTrue(run.out().contains("in no rock"), run.out());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--porosity=1.5 | porosity must lie between 0 and 1: porosity=1.5",
        "--porosity=x | --porosity must be a number",
        "--size=0 | image size must be at least 1 voxel",
        "--radius=0.5 | radius of the spheres must lie between 1 and 10000 voxels: radius=0.5",
        "--seed=1.5 | --seed must be an integer",
        "--tolerance=0 | tolerance must lie between 0 and 1",
        "--max-steps=0 | steps must number at least 1",
        "--threads=0 | threads must number 1 to 4096",
        "--box=0,0,0,4,4,4 | --box must come with an IMAGE",
        "--voxel-edge=1 | --voxel-edge must come with an IMAGE",
        "--approach=plain | argument must be known: --approach",
        "--json --csv | --json and --csv must not be combined",
      })
  void optionsMustBePossible(String options, String line) {
    List<String> all = new ArrayList<>(List.of("steady-study"));
    all.addAll(List.of(options.split(" ")));
    Cli.run(all.toArray()).assertRefused(2, line);
  }

  @Test
  void optionsOfSpheresAreRefusedWithAnImage() throws IOException {
    RawFile.write(folder, 4, 4, 4, (x, y, z) -> x > 0);
    for (String option : List.of("--porosity=0.5", "--size=8", "--radius=3", "--seed=1")) {
      Cli.run("steady-study", folder.resolve("image.raw"), "--dims=4,4,4", option)
          .assertRefused(2, "must come with random spheres, not an image");
    }
  }

  @Test
  void outputMustBeWritable() throws IOException {
    Path file = Files.createFile(folder.resolve("file"));
    small("--output=" + file).assertRefused(3, "output must be a folder");
    small("--output=" + file.resolve("below")).assertRefused(3, "output must be writable");
  }

  @Test
  void heapMustHoldIt() {
    Cli.run(new Host(40L << 20, false), "steady-study").assertRefused(5, "-Xmx");
    Cli.run(new Host(40L << 20, false), "steady-study", "--size=1000")
        .assertRefused(5, "5 rocks of 1000^3 voxels", "-Xmx");
  }

  @Test
  void interruptionEndsItWithNothingWritten() {
    Path result = folder.resolve("result");
    Thread.currentThread().interrupt();
    Cli run = small("--output=" + result);
    assertTrue(Thread.interrupted());
    assertEquals(130, run.code(), run.err());
    assertEquals("", run.out());
    assertEquals(
        List.of(
            "hdispatch: warning: 0 of 2 rocks are done, no files are written",
            "hdispatch: interrupted"),
        run.err().lines().toList());
    assertFalse(Files.exists(result));
  }

  @Test
  void interruptedStudyKeepsTheRocksThatAreDone() {
    PoreSpace duct = PoreSpace.of(6, 6, 8, (x, y, z) -> x > 0);
    Rock rock =
        new Rock(
            "duct", duct, Optional.empty(), OptionalDouble.empty(), new TreeMap<>(), List.of());
    SteadyStudy study =
        new SteadyStudy(List.of(rock, rock, rock), FlowOptions.DEFAULT, 1, line -> {});
    assertThrows(
        CancellationException.class,
        () ->
            study.run(
                (number, which, run, now) -> {
                  if (number == 2 && run.equals("plain")) {
                    Thread.currentThread().interrupt();
                  }
                }));
    assertTrue(Thread.interrupted());
    assertEquals(1, study.result().rocks().size());
  }
}
