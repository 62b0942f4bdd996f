package org.hdispatch.app.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.hdispatch.app.Cli;
import org.hdispatch.app.Forked;
import org.hdispatch.app.draw.StudyPageTest;
import org.hdispatch.app.rock.SampleRock;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.survey.Shard;
import org.hdispatch.porous.survey.SurveyFiles;
import org.hdispatch.porous.survey.SurveyJob;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveySettings;
import org.hdispatch.porous.survey.SurveyStatus;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class SurveyReportCommandTest {
  private static final String SAMPLE = new SampleRock().name();
  private static final List<String> FIGURES =
      List.of("porosity", "porosity_connected", "permeability_mD");

  @TempDir Path folder;

  /**
   * A survey of cubes of 16 or 32 voxels along x and z: in block n, porosity is (n + 1)/10 and k is
   * {@code factor} (n + 1), but the last one does not percolate along z.
   */
  private Path survey(String name, String image, String method, int edge, double factor)
      throws IOException {
    Path to = Files.createDirectories(folder.resolve(name));
    Map<String, String> settings = new LinkedHashMap<>();
    int blocks = 64 / edge;
    settings.put("jobs", Integer.toString(2 * blocks));
    settings.put("image", image);
    settings.put("image_size", "64,64,64");
    settings.put("block", edge + "," + edge + "," + edge);
    settings.put("blocks", "0-" + (blocks - 1));
    settings.put("axes", "x,z");
    settings.put("method", method);
    settings.put("pore_values", "1");
    try (SurveyFiles files =
        SurveyFiles.open(to, Shard.WHOLE, new SurveySettings(settings), FIGURES, List.of("job"))) {
      for (int n = 0; n < 2 * blocks; n++) {
        int block = n / 2;
        boolean dead = n == 2 * blocks - 1;
        files.append(
            new SurveyRow(
                new SurveyJob(
                    n,
                    block,
                    new VoxelBox(block * edge, 0, 0, edge, edge, edge),
                    n % 2 == 0 ? Axis.X : Axis.Z),
                dead ? SurveyStatus.DOES_NOT_PERCOLATE : SurveyStatus.DONE,
                "",
                Map.of(
                    "porosity", Double.toString((block + 1) / 10.0),
                    "porosity_connected", Double.toString((block + 1) / 10.0),
                    "permeability_mD", Double.toString(dead ? 0 : factor * (block + 1)))),
            List.of(Integer.toString(n)));
      }
    }
    return to;
  }

  private Path points(String more) throws IOException {
    return Files.writeString(
        folder.resolve("points.csv"), "label,porosity,permeability_mD,block,axis,size\n" + more);
  }

  private List<Map<String, String>> rows(String kind) throws IOException {
    return SurveyCommandTest.rows(folder.resolve("out/survey-report.csv")).stream()
        .filter(row -> row.get("kind").equals(kind))
        .toList();
  }

  private Cli report(Object... args) {
    List<Object> all = new ArrayList<>(List.of("survey-report", "--output", folder.resolve("out")));
    all.addAll(List.of(args));
    return Cli.run(all.toArray());
  }

  private Document page() throws Exception {
    String html = Files.readString(folder.resolve("out/survey-report.html"));
    for (String bad : List.of("NaN", "null", "Infinity", "Optional", "<script")) {
      assertFalse(html.contains(bad), bad);
    }
    return StudyPageTest.parsed(html);
  }

  private static List<String> texts(Document page, String tag) {
    NodeList all = page.getElementsByTagName(tag);
    return IntStream.range(0, all.getLength()).mapToObj(n -> all.item(n).getTextContent()).toList();
  }

  @Test
  void pageHasFigureSizesSlicesMapsAndTables() throws Exception {
    Cli run =
        report(
            survey("small", SAMPLE, "lbm", 16, 100),
            survey("large", SAMPLE, "lbm", 32, 110),
            "--porosity-sizes");
    assertEquals(0, run.code(), run.err());
    assertEquals("", run.err());
    Document page = page();
    assertEquals(
        List.of(
            "What was found",
            "Permeability against porosity",
            "Size of the blocks",
            "Slices: " + SAMPLE,
            "Map: " + SAMPLE + ", 16\u00b3, LBM",
            "Map: " + SAMPLE + ", 32\u00b3, LBM",
            "Blocks: " + SAMPLE + ", 16\u00b3, LBM",
            "Blocks: " + SAMPLE + ", 32\u00b3, LBM",
            "Settings",
            "Do it again"),
        texts(page, "h2"));
    assertEquals(3, page.getElementsByTagName("img").getLength());
    assertTrue(texts(page, "td").contains("z: does not percolate"));
    Document figure = StudyPageTest.parsed(Files.readString(folder.resolve("out/figure5.svg")));
    List<String> legend = texts(figure, "text");
    assertTrue(legend.contains(SAMPLE + ", 32\u00b3, LBM"), legend.toString());
    assertTrue(legend.contains("Fontainebleau sandstone: Bourbie & Zinszner 1985"));
    assertTrue(String.join(" ", legend).contains("Jennings & Lucia 2003"), legend.toString());
    assertTrue(legend.contains("flow along x") && !legend.contains("flow along y"));
    BufferedImage png = ImageIO.read(folder.resolve("out/figure5.png").toFile());
    Element svg = figure.getDocumentElement();
    assertEquals(3 * Integer.parseInt(svg.getAttribute("width")), png.getWidth());
    assertEquals(3 * Integer.parseInt(svg.getAttribute("height")), png.getHeight());
  }

  @Test
  void everythingDrawnIsInTheTable() throws Exception {
    assertEquals(
        0,
        report(
                survey("small", SAMPLE, "lbm", 16, 100),
                survey("large", SAMPLE, "lbm", 32, 110),
                "--label=A rock",
                "--label=A rock",
                "--porosity-sizes")
            .code());
    assertEquals(7 + 3, rows("point").size());
    List<Map<String, String>> fits = rows("fit");
    assertEquals(
        List.of("A rock, 16\u00b3, LBM", "A rock, 32\u00b3, LBM"),
        fits.stream().map(row -> row.get("name")).toList());
    assertTrue(Double.parseDouble(fits.get(0).get("constant_error")) > 0);
    List<Map<String, String>> sizes = rows("size");
    Map<String, String> alongZ =
        sizes.stream()
            .filter(
                row -> row.get("axis").equals("z") && row.get("block_edge_voxel").equals("16.0"))
            .findFirst()
            .orElseThrow();
    assertEquals("1", alongZ.get("do_not_percolate"));
    assertEquals("4", alongZ.get("count"));
    assertEquals(150, Double.parseDouble(alongZ.get("mean")), 1e-12); // of 100, 200, 300 and 0
    assertEquals(
        List.of("8.0", "16.0", "32.0"),
        sizes.stream()
            .filter(row -> row.get("name").equals("A rock, whole image"))
            .map(row -> row.get("block_edge_voxel"))
            .toList());
    assertTrue(
        rows("band").stream().allMatch(row -> row.get("source").matches("(Jennings|Bourbie).*")));
    assertEquals(
        SurveyCommandTest.rows(folder.resolve("out/survey-report.csv")).size(),
        Files.readString(folder.resolve("out/survey-report.json")).split("\"kind\"").length - 1);
  }

  @Test
  void ratiosToGivenPointsAndOfParticlesToTheLatticeAreSaid() throws Exception {
    Cli run =
        report(
            survey("a", SAMPLE, "lbm", 16, 100),
            survey("b", SAMPLE, "sph", 16, 120),
            "--points",
            points("Lab,0.1,200,0,x,16\nLab,0.2,100,1,x,16\nLab,0.2,100,1,x,32\n"),
            "--band=none");
    assertEquals(0, run.code(), run.err());
    assertTrue(
        run.out().contains("16\u00b3, LBM over Lab: median 1.25, 0.50 to 2.00 in 2 blocks"),
        run.out());
    assertTrue(
        run.out()
            .contains("16\u00b3, SPH over " + SAMPLE + ", 16\u00b3, LBM: median 1.20, 1.20 to"),
        run.out());
    assertEquals(3, rows("given").size());
    assertEquals(3, rows("ratio").size());
    assertEquals(0, rows("band").size());
    page();
  }

  @Test
  void imageThatIsNotThereIsSaidAndLeftOut() throws Exception {
    Path survey = survey("a", "rock.raw", "lbm", 16, 100);
    Cli run = report(survey);
    assertEquals(0, run.code());
    assertTrue(run.err().contains("image is not here, there are no slices"), run.err());
    assertEquals(0, page().getElementsByTagName("img").getLength());
    Files.write(folder.resolve("rock.raw"), new byte[64 * 64 * 64]);
    assertEquals("", report(survey).err());
    assertEquals(3, page().getElementsByTagName("img").getLength());
  }

  @Test
  void tensorsAndTheUpscaledSampleAreShownIfTheyLieBesideTheRows() throws Exception {
    Path survey = survey("a", SAMPLE, "lbm", 16, 100);
    Files.writeString(
        survey.resolve("survey-tensor.csv"),
        "block,permeability_xx_voxel2,permeability_xy_voxel2,other\n0,0.123456,,1\n3,2.5,,1\n");
    Files.writeString(survey.resolve("upscale.csv"), "axis,permeability_mD\nz,1234.5678\n");
    assertEquals(0, report(survey).code());
    Document page = page();
    assertTrue(texts(page, "h2").contains("Tensors and the whole: " + SAMPLE + ", 16\u00b3, LBM"));
    assertTrue(texts(page, "th").contains("k xx, voxel\u00b2"));
    assertFalse(texts(page, "th").contains("k xy, voxel\u00b2")); // as it is empty
    assertTrue(texts(page, "td").containsAll(List.of("0.123", "2.5", "1230")));
    Files.writeString(survey.resolve("upscale.csv"), "axis,permeability_mD\nz\n");
    report(survey).assertRefused(3, "as many values as the header");
  }

  @Test
  void commandOfTheSurveyIsSaid() throws Exception {
    report(survey("a", "my rock.raw", "lbm", 16, 100), "--quiet");
    String command = texts(page(), "pre").get(0);
    assertEquals(
        "./hdispatch survey 'my rock.raw' --dims 64,64,64 --block 16,16,16 --blocks 0-3"
            + " --pore-value 1 --axis x,z --method lbm --output "
            + folder.resolve("a"),
        command);
  }

  @Test
  void whatCannotBeMeantIsRefused() throws Exception {
    Path survey = survey("a", SAMPLE, "lbm", 16, 100);
    report(folder.resolve("none")).assertRefused(3, "folder must hold a survey");
    report(survey, "--label=a", "--label=b").assertRefused(2, "--label must come once for each");
    report(survey, "--band=lucia,none").assertRefused(2, "none alone");
    report(survey, "--band=berea").assertRefused(2, "--band must be some of");
    report(survey, "--image=other.h5").assertRefused(2, "--image must be the image of a survey");
    report(survey, "--points", folder.resolve("x.csv")).assertRefused(3, "points must be readable");
    report().assertRefused(2, "SURVEY_DIR");
  }

  /** A class that is not there stands for the fonts: whoever asks for one fails. */
  @Test
  void figureNeedsNoFonts() throws Exception {
    Process run =
        Forked.program(
            List.of("-Xmx256m", "-Djava.awt.headless=true", "-Dsun.font.fontmanager=no.Fonts"),
            List.of(
                "survey-report",
                survey("a", SAMPLE, "lbm", 16, 100).toString(),
                "--quiet",
                "--output",
                folder.resolve("out").toString()));
    assertEquals(0, Forked.ended(run));
    assertTrue(Files.size(folder.resolve("out/figure5.png")) > 0);
  }
}
