package org.hdispatch.app.permeability;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.hdispatch.app.Cli;
import org.hdispatch.app.RawFile;
import org.hdispatch.app.console.Host;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PermeabilityCommandTest {
  /** The keys that programs rely on, in their order. */
  private static final List<String> KEYS =
      List.of(
          "permeability_m2",
          "permeability_mD",
          "permeability_voxel2",
          "permeability_x_voxel2",
          "permeability_y_voxel2",
          "permeability_z_voxel2",
          "k_error_estimate",
          "change_at_stop",
          "porosity",
          "porosity_connected",
          "percolates",
          "converged",
          "steps",
          "tau",
          "superficial_velocity",
          "pore_velocity",
          "reynolds",
          "mach",
          "seconds_stepping",
          "mflups",
          "threads",
          "method",
          "lattice",
          "collision",
          "axis",
          "voxel_edge_m",
          "sides",
          "inlet",
          "inlet_layers",
          "collector",
          "collections",
          "gc_pause_ms",
          "stopped_ms",
          "stall_ms",
          "bytes_per_step");

  /** A part of the bundled rock that is solved in a moment. */
  private static final String SMALL = "--box=32,32,32,24,24,24";

  /** k/W² of a square duct (series of White, Viscous Fluid Flow, eq. 3-48). */
  private static final double SQUARE_DUCT = 0.0351442537;

  @TempDir Path folder;

  private static double number(Map<String, String> json, String key) {
    return Double.parseDouble(json.get(key));
  }

  @Test
  void jsonHasItsKeysInTheirOrder() {
    Map<String, String> json = Cli.json("permeability", "--json", "--spheres=sc", "--size=8");
    assertEquals(KEYS, json.keySet().stream().limit(KEYS.size()).toList());
    assertEquals("\"lbm\"", json.get("method"));
    assertEquals("\"D3Q19\"", json.get("lattice"));
    assertEquals("\"trt\"", json.get("collision"));
    assertEquals("\"corrected\"", json.get("approach"));
    assertTrue(number(json, "seconds_pressure") > 0);
    assertTrue(number(json, "flux_imbalance") >= 0);
    assertEquals("\"z\"", json.get("axis"));
    assertEquals("\"periodic\"", json.get("sides"));
    assertEquals("0", json.get("inlet_layers"));
    assertEquals("true", json.get("converged"));
  }

  @Test
  void spheresHaveNoSizeUntilTheVoxelEdgeIsGiven() {
    Map<String, String> unknown =
        Cli.json("permeability", "--json", "--spheres=bcc", "--size=8", "--solid-fraction=0.2");
    for (String key : List.of("permeability_m2", "permeability_mD", "pore_velocity", "reynolds")) {
      assertEquals("null", unknown.get(key), key);
    }
    Map<String, String> known =
        Cli.json(
            "permeability",
            "--json",
            "--spheres=bcc",
            "--size=8",
            "--solid-fraction=0.2",
            "--voxel-edge=1e-6");
    double voxel2 = number(known, "permeability_voxel2");
    assertEquals(number(unknown, "permeability_voxel2"), voxel2);
    assertEquals(voxel2 * 1e-12, number(known, "permeability_m2"), 1e-12 * voxel2 * 1e-12);
    // 1 D = 9.869233e-13 m²
    assertEquals(
        voxel2 * 1e-12 / 9.869233e-16, number(known, "permeability_mD"), 1e-9 * voxel2 * 1000);
  }

  @Test
  void velocitiesFollowFromDarcysLaw() {
    Map<String, String> json =
        Cli.json(
            "permeability",
            "--json",
            "--spheres=sc",
            "--size=8",
            "--voxel-edge=1e-5",
            "--viscosity=2e-6",
            "--density=800",
            "--pressure-gradient=50");
    double q = number(json, "permeability_m2") / (2e-6 * 800) * 50;
    assertEquals(q, number(json, "superficial_velocity"), 1e-12 * q);
    double u = q / number(json, "porosity_connected");
    assertEquals(u, number(json, "pore_velocity"), 1e-12 * u);
    double diameter = number(json, "hydraulic_diameter_voxel") * 1e-5;
    assertEquals(u * diameter / 2e-6, number(json, "reynolds"), 1e-12);
  }

  @Test
  void flowThatDarcysLawDoesNotHoldForIsWarnedOf() {
    Object[] fast = {
      "permeability", "--spheres=sc", "--size=8", "--voxel-edge=1e-3", "--pressure-gradient=1000"
    };
    Cli warned = Cli.run(fast);
    assertEquals(0, warned.code());
    assertTrue(warned.err().startsWith("hdispatch: warning: Reynolds number"), warned.err());
    Object[] quiet = Arrays.copyOf(fast, fast.length + 1);
    quiet[fast.length] = "--quiet";
    assertEquals("", Cli.run(quiet).err());
  }

  @ParameterizedTest
  @ValueSource(strings = {"--inlet-layers=4", "--inlet=periodic", "--inlet=pressure"})
  void allPoreWithWallsIsADuct(String inlet) {
    int width = 10;
    Path image = RawFile.write(folder, width, width, 16, (x, y, z) -> true);
    Map<String, String> json =
        Cli.json(
            "permeability",
            image,
            "--json",
            "--dims=10,10,16",
            "--voxel-edge=1e-6",
            inlet,
            "--tolerance=1e-4");
    assertEquals("true", json.get("converged"));
    assertEquals("1.0", json.get("porosity"));
    double exact = SQUARE_DUCT * width * width;
    // O(1/W²) of half-way bounce-back; with slabs half as much again, for L + 2 B = 1.5 L of duct
    assertEquals(exact, number(json, "permeability_voxel2"), 1.5 * exact / (width * width));
  }

  @Test
  void rockThatDoesNotPercolateIsAResult() {
    Path image = RawFile.write(folder, 6, 6, 6, (x, y, z) -> z != 3);
    Object[] args = {"permeability", image, "--dims=6,6,6", "--voxel-edge=1e-6", "--json"};
    Map<String, String> json = Cli.json(args);
    assertEquals("0.0", json.get("permeability_m2"));
    assertEquals("0.0", json.get("permeability_mD"));
    assertEquals("0.0", json.get("permeability_voxel2"));
    assertEquals("false", json.get("percolates"));
    assertEquals("true", json.get("converged"));
    assertEquals("0", json.get("steps"));
    assertEquals("null", json.get("tau"));
    args[4] = "--quiet";
    Cli text = Cli.run(args);
    assertEquals(0, text.code());
    assertTrue(text.out().contains("NO, nothing spans z: k = 0"), text.out());
  }

  @Test
  void rockThatDoesNotPercolateIsDrawnAsSolidAlone() throws IOException {
    Path image = RawFile.write(folder, 6, 6, 6, (x, y, z) -> z != 3);
    Path result = folder.resolve("result");
    Cli.json(
        "permeability", image, "--dims=6,6,6", "--voxel-edge=1e-6", "--json", "--output=" + result);
    assertEquals(new TreeSet<>(List.of("flow.vti", "result.json")), names(result));
  }

  @Test
  void bundledRockConverges() {
    Map<String, String> json = Cli.json("permeability", "--json", SMALL, "--tolerance=0.05");
    assertEquals("true", json.get("converged"));
    assertEquals("5.345E-6", json.get("voxel_edge_m"));
    assertTrue(number(json, "k_error_estimate") <= 0.05);
    assertTrue(number(json, "permeability_mD") > 0);
    assertEquals("\"wall\"", json.get("sides"));
    assertEquals("\"slab\"", json.get("inlet"));
  }

  @Test
  void bundledRockConvergesBetweenMirrorsUnderPressure() {
    Object[] args = {
      "permeability", SMALL, "--tolerance=0.05", "--sides=mirror", "--inlet=pressure"
    };
    Cli table = Cli.run(args);
    assertTrue(table.out().contains("sides mirror, inlet and outlet pressure\n"), table.out());
    Object[] form = Arrays.copyOf(args, args.length + 1);
    form[args.length] = "--json";
    Map<String, String> json = Cli.json(form);
    assertEquals("\"mirror\"", json.get("sides"));
    assertEquals("\"pressure\"", json.get("inlet"));
    assertEquals("0", json.get("inlet_layers"));
    assertTrue(number(json, "permeability_mD") > 0);
  }

  @Test
  void tableTellsWhatAPersonAsksFor() {
    Cli run = Cli.run("permeability", SMALL, "--max-steps=250", "--tolerance=1e-9");
    for (String word :
        List.of(
            " mD = ",
            " m2 = ",
            " voxel2",
            "NOT CONVERGED",
            "flux balanced to",
            "corrections in",
            "percolates",
            "connected along z",
            "(chosen)",
            "MFLUPS",
            "Reynolds",
            "Mach",
            "sides wall",
            "slab of 6 layers",
            "threads",
            "collections",
            "bytes per step",
            "warm-up",
            "doi:10.6084/m9.figshare.1153794",
            "Phys. Rev. E 80, 036307")) {
      assertTrue(run.out().contains(word), () -> word + " <- " + run.out());
    }
    assertTrue(
        run.out().chars().allMatch(c -> c < 128), "terminals without UTF-8 print ASCII only");
  }

  @Test
  void resultThatHasNotConvergedIsPrintedAndFlagged() {
    Cli run = Cli.run("permeability", "--json", SMALL, "--max-steps=50", "--threads=1");
    assertEquals(4, run.code());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().contains("give more --max-steps"), run.err());
    assertEquals("false", run.members().get("converged"));
    assertEquals("50", run.members().get("steps"));
    assertEquals("1", run.members().get("threads"));
    assertTrue(number(run.members(), "permeability_voxel2") > 0);
  }

  @Test
  void csvIsTheSameAsJson() {
    Object[] args = {"permeability", "--spheres=sc", "--size=6", "--tau=1", "--json"};
    Map<String, String> json = Cli.json(args);
    args[4] = "--csv";
    List<String> csv = Cli.run(args).out().lines().toList();
    assertEquals(2, csv.size());
    List<String> header = List.of(csv.get(0).split(",", -1));
    List<String> row = List.of(csv.get(1).split(",", -1));
    assertEquals(List.copyOf(json.keySet()), header);
    assertEquals(header.size(), row.size());
    assertEquals("", row.get(header.indexOf("permeability_m2")));
    String k = row.get(header.indexOf("permeability_voxel2"));
    assertEquals(json.get("permeability_voxel2"), k);
  }

  @Test
  void voxelEdgeOfTheOptionWinsOverThatOfTheFile() {
    Map<String, String> json =
        Cli.json("permeability", "--json", SMALL, "--tolerance=0.5", "--voxel-edge=1e-6");
    assertEquals("1.0E-6", json.get("voxel_edge_m"));
  }

  @Test
  void filesHoldTheResultAndItsFields() throws IOException {
    Path result = folder.resolve("made/as/needed");
    Cli run = Cli.run("permeability", SMALL, "--json", "--tolerance=0.2", "--output=" + result);
    assertEquals(0, run.code(), run.err());
    assertEquals(
        new TreeSet<>(
            List.of("flow.vti", "result.json", "speed-x.png", "speed-y.png", "speed-z.png")),
        names(result));
    assertEquals(run.out(), Files.readString(result.resolve("result.json")));
    assertEquals(480, ImageIO.read(result.resolve("speed-x.png").toFile()).getWidth());

    byte[] vti = Files.readAllBytes(result.resolve("flow.vti"));
    String header = new String(vti, 0, 1200, StandardCharsets.ISO_8859_1);
    assertTrue(header.contains("WholeExtent=\"0 24 0 24 0 24\""), header);
    assertTrue(header.contains("Spacing=\"5.345E-6 5.345E-6 5.345E-6\""), header);
    for (String name : List.of("velocity (m/s)", "pressure (Pa)", "solid")) {
      assertTrue(header.contains("Name=\"" + name + "\""), header);
    }
    assertEquals(
        number(run.members(), "superficial_velocity"),
        meanVelocityAlongZ(vti, 24 * 24 * 24),
        1e-5 * number(run.members(), "superficial_velocity")); // float32
  }

  /** Velocity is the first array: 8 bytes of length, then 3 floats a voxel, little-endian. */
  private static double meanVelocityAlongZ(byte[] vti, int voxels) {
    String text = new String(vti, StandardCharsets.ISO_8859_1);
    int start = text.indexOf("<AppendedData encoding=\"raw\">\n_") + 31;
    var values = java.nio.ByteBuffer.wrap(vti).order(java.nio.ByteOrder.LITTLE_ENDIAN);
    assertEquals(12L * voxels, values.getLong(start));
    double sum = 0;
    for (int voxel = 0; voxel < voxels; voxel++) {
      sum += values.getFloat(start + 8 + 12 * voxel + 8);
    }
    return sum / voxels;
  }

  @Test
  void filesAreInVoxelsWhenTheEdgeIsUnknown() throws IOException {
    Cli.json("permeability", "--json", "--spheres=sc", "--size=6", "--output=" + folder);
    String header =
        new String(
            Files.readAllBytes(folder.resolve("flow.vti")), 0, 1000, StandardCharsets.ISO_8859_1);
    assertTrue(header.contains("Spacing=\"1.0 1.0 1.0\""), header);
    assertTrue(header.contains("Name=\"velocity (voxel2)\""), header);
    assertTrue(header.contains("Name=\"pressure (voxel)\""), header);
  }

  @Test
  void plainApproachMakesNoCorrections() {
    Map<String, String> json =
        Cli.json("permeability", "--json", SMALL, "--tolerance=0.2", "--approach=plain");
    assertEquals("\"plain\"", json.get("approach"));
    assertEquals("0", json.get("corrections"));
    assertEquals(0, number(json, "seconds_pressure"));
  }

  @Test
  void threadsDoNotChangeABit() {
    String[] k = new String[3];
    for (int threads = 1; threads <= k.length; threads++) {
      k[threads - 1] =
          Cli.json("permeability", "--json", SMALL, "--tolerance=0.2", "--threads=" + threads)
              .get("permeability_voxel2");
    }
    assertArrayEquals(new String[] {k[0], k[0], k[0]}, k);
  }

  @Test
  void progressIsShownOnATerminalOnly() {
    Object[] args = {"permeability", SMALL, "--max-steps=100"};
    Host terminal = new Host(Runtime.getRuntime().maxMemory(), true);
    String shown = Cli.run(terminal, args).err();
    assertTrue(shown.startsWith("\rstep 30  k "), shown);
    assertTrue(shown.contains("MFLUPS  ETA "), shown);
    assertTrue(!Cli.run(args).err().contains("\r"));
  }

  private static TreeSet<String> names(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return new TreeSet<>(files.map(file -> file.getFileName().toString()).toList());
    }
  }

  @Test
  void particlesGiveTheSameRow() {
    String[] args = {"permeability", "--json", "--method=sph", SMALL, "--max-steps=40"};
    Cli run = Cli.run((Object[]) args);
    assertEquals(4, run.code(), run.err()); // 40 steps do not suffice
    Map<String, String> json = run.members();
    assertEquals(KEYS, json.keySet().stream().limit(KEYS.size()).toList());
    assertEquals("\"sph\"", json.get("method"));
    assertEquals("null", json.get("lattice"));
    assertTrue(number(json, "particles") > number(json, "fluid_nodes"));
    assertTrue(number(json, "permeability_voxel2") > 0);
    Cli table = Cli.run("permeability", "--method=sph", SMALL, "--max-steps=40");
    assertTrue(table.out().contains("smoothed particle hydrodynamics"), table.out());
  }

  /** Ctrl-C once the first progress is shown. */
  @Test
  void interruptionOfParticlesLeavesNoFile() {
    Path result = folder.resolve("result");
    StringWriter err =
        new StringWriter() {
          @Override
          public void write(String text, int from, int length) {
            super.write(text, from, length);
            if (text.contains("step ")) {
              Thread.currentThread().interrupt();
            }
          }
        };
    Cli run =
        Cli.run(
            new Host(Runtime.getRuntime().maxMemory(), true),
            err,
            "permeability",
            "--method=sph",
            SMALL,
            "--output=" + result);
    assertTrue(Thread.interrupted());
    assertEquals(130, run.code(), run.err());
    assertEquals("", run.out());
    String[] lines = run.err().split("\r");
    assertEquals("hdispatch: interrupted\n", lines[lines.length - 1]);
    assertFalse(Files.exists(result));
  }

  @Test
  void finerVoxelsAreTheSameRock() {
    Map<String, String> json =
        Cli.json("permeability", "--json", "--refine=2", "--box=32,32,32,12,12,12");
    assertEquals(24, number(json, "nx"));
    assertEquals(5.345e-6 / 2, number(json, "voxel_edge_m"), 1e-12);
  }

  @Test
  void whatParticlesDoNotTakeIsRefused() {
    Cli.run("permeability", "--method=sph", "--wall-factor=0.5").assertRefused(2, "beta_max=0.5");
    Cli.run("permeability", "--method=sph", "--smoothing-length=3").assertRefused(2, "h=3.0");
    Cli.run("permeability", "--method=sph", "--sides=periodic", "--box=0,0,0,3,32,32")
        .assertRefused(2, "axis=X, length=3 voxels, reach=3.1 voxels");
    Cli.run("permeability", "--method=sph", "--sides=mirror").assertRefused(2, "sides=MIRROR");
    Cli.run("permeability", "--method=sph", "--tau=1").assertRefused(2, "--tau");
    Cli.run("permeability", "--smoothing-length=1.5").assertRefused(2, "--method sph");
    Cli.run("permeability", "--refine=0").assertRefused(2, "N=0");
  }

  @Test
  void allAxesGiveThreeResultsAndTheTensor(@TempDir Path folder) throws IOException {
    Object[] command = {
      "permeability",
      "--spheres=sc",
      "--size=12",
      "--solid-fraction=0.343",
      "--axis=all",
      "--quiet",
      "--output=" + folder.resolve("o"),
      "--json"
    };
    Cli run = Cli.run(command);
    assertEquals(0, run.code(), run.err());
    for (String part :
        List.of(
            "{\n\"summary\": {",
            "\"permeability_xy_voxel2\": ",
            "\"principal_3_z\": ",
            "\"rows\": [",
            "\"axis\": \"x\"",
            "\"axis\": \"y\"",
            "\"axis\": \"z\"")) {
      assertTrue(run.out().contains(part), () -> part + " <- " + run.out());
    }
    String tensor = Files.readString(folder.resolve("o/tensor.json"));
    String inner = tensor.substring(2, tensor.length() - 3);
    assertTrue(run.out().contains(inner), tensor);
    for (String axis : List.of("x", "y", "z")) {
      assertTrue(Files.exists(folder.resolve("o/" + axis + "/flow.vti")));
      assertTrue(
          Files.readString(folder.resolve("o/" + axis + "/result.json"))
              .contains("\"axis\": \"" + axis + "\""));
    }
    command[7] = "--csv";
    assertEquals(4, Cli.run(command).out().lines().count());
    Cli walls = Cli.run("permeability", "--box=32,32,32,24,24,24", "--axis=all", "--quiet");
    assertEquals(0, walls.code(), walls.err());
    assertTrue(walls.out().contains("what flows across needs --sides periodic"), walls.out());
    Cli.run("permeability", "--axis=all", "--gc-report=" + folder.resolve("gc.json"))
        .assertRefused(2, "--gc-report must come with one axis");
    Cli.run("permeability", "--axis=w").assertRefused(2, "--axis must be one of x, y, z, all");
  }
}
