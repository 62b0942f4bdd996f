package org.hdispatch.app.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.hdispatch.app.Cli;
import org.hdispatch.app.console.Host;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DuctCommandTest {
  /** The keys that programs rely on, in their order. */
  private static final List<String> KEYS =
      List.of(
          "mlups_median",
          "mlups_best",
          "bandwidth_GBps",
          "bandwidth_fraction",
          "bytes_per_node",
          "bytes_moved_per_node",
          "seconds_per_step",
          "k_over_w2",
          "k_over_w2_series",
          "steady",
          "start_up_left",
          "size",
          "bundle",
          "bundles",
          "threads",
          "lattice",
          "storage",
          "streaming",
          "kernel",
          "steps",
          "last_step");

  /** So little heap that the probe of the bandwidth is small, and fast. */
  private static final long HEAP = 64L << 20;

  @TempDir Path folder;

  private Host host() {
    return new Host(HEAP, false, Optional.of(machineFile()));
  }

  private Path machineFile() {
    return folder.resolve("config").resolve("machine.properties");
  }

  private Cli duct(String... words) {
    return Cli.run(host(), (Object[]) command(words));
  }

  private static String[] command(String... words) {
    String all = String.join(" ", words);
    List<String> command = new ArrayList<>(List.of("duct"));
    command.addAll(List.of(all.split(" +")));
    if (!all.contains("--steps")) {
      command.add("--steps=2");
    }
    return command.toArray(String[]::new);
  }

  private Map<String, String> json(String words) {
    Cli run = duct(words + " --json");
    assertEquals(0, run.code(), run.err());
    assertEquals("", run.err());
    return run.members();
  }

  private static double number(Map<String, String> json, String key) {
    return Double.parseDouble(json.get(key));
  }

  private static TreeSet<String> names(Path of) throws IOException {
    try (Stream<Path> files = Files.list(of)) {
      return new TreeSet<>(files.map(file -> file.getFileName().toString()).toList());
    }
  }

  @Test
  void jsonHasItsKeysInTheirOrder() {
    Map<String, String> json = json("--size=8 --bundle=8,4,4 --warm-up=3 --threads=2");
    assertEquals(KEYS, json.keySet().stream().limit(KEYS.size()).toList());
    assertEquals("8", json.get("size"));
    assertEquals("\"8,4,4\"", json.get("bundle"));
    assertEquals("4", json.get("bundles"));
    assertEquals("2", json.get("threads"));
    assertEquals("\"D3Q15\"", json.get("lattice"));
    assertEquals("\"double\"", json.get("storage"));
    assertEquals("\"in-place\"", json.get("streaming"));
    assertEquals("2", json.get("steps"));
    assertEquals("3", json.get("warm_up_steps"));
    assertEquals("5", json.get("last_step"));
    assertEquals("240", json.get("bytes_moved_per_node"));
    assertTrue(json.containsKey("bytes_per_step"));
    assertTrue(json.containsKey("collections"));
  }

  @Test
  void figuresFitTogether() {
    Map<String, String> json = json("--size=12");
    double nodes = 12 * 12 * 12;
    double mlups = number(json, "mlups_median");
    assertEquals(nodes / number(json, "seconds_per_step") * 1e-6, mlups, 1e-9 * mlups);
    double fraction = mlups * 1e6 * 240 / (number(json, "bandwidth_GBps") * 1e9);
    assertEquals(fraction, number(json, "bandwidth_fraction"), 1e-9 * fraction);
    assertTrue(number(json, "mlups_best") >= mlups);
    assertTrue(number(json, "bytes_per_node") >= 120);
  }

  @Test
  void steadyFlowHasThePermeabilityOfTheSeries() {
    Map<String, String> json = json("--size=16 --steady");
    assertEquals("true", json.get("steady"));
    // 0.58 % at W = 16, half-way bounce-back
    assertEquals(number(json, "k_over_w2_series"), number(json, "k_over_w2"), 0.006 * 0.0351442537);
  }

  @Test
  void shortRunSaysThatItIsNotSteady() {
    Map<String, String> json = json("--size=16 --warm-up=8");
    assertEquals("false", json.get("steady"));
    assertTrue(number(json, "k_over_w2") < 0.01);
    Cli text = duct("--size=16 --warm-up=8");
    assertTrue(text.out().contains("NOT STEADY"), text.out());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--streaming=pull",
        "--streaming=push",
        "--bundle=5",
        "--bundle=all,2,7",
        "--threads=3",
        "--kernel=reference"
      })
  void settingsThatOnlyChangeTheSpeedChangeNothingElse(String setting) {
    String size = "--size=10 --warm-up=21 ";
    double k = number(json(size), "k_over_w2");
    // sums of the same velocities in another order
    assertEquals(k, number(json(size + setting), "k_over_w2"), 1e-12 * k);
  }

  @Test
  void singlePrecisionMovesHalf() {
    Map<String, String> json = json("--size=8 --storage=single --lattice=d3q19 --streaming=PULL");
    assertEquals("228", json.get("bytes_moved_per_node")); // 3 * 19 * 4
    assertEquals("\"single\"", json.get("storage"));
  }

  @Test
  void tableTellsWhatAPersonAsksFor() {
    Cli run = duct("--size=8 --bundle=all,4,4 --steps=3");
    assertEquals(0, run.code(), run.err());
    for (String word :
        List.of(
            "8 x 8 x 8 nodes",
            "8 x 4 x 4 nodes (given), 4 of them",
            "MLUPS median",
            "best (4 steps, two by two", // raised to an even number
            "GB/s read plus written in place",
            "% (240 bytes to move",
            "bytes held a node",
            "0.0351442537",
            "bytes per step",
            "warm-up apart        10000 steps")) {
      assertTrue(run.out().contains(word), () -> word + " <- " + run.out());
    }
    assertTrue(run.out().chars().allMatch(c -> c < 128));
  }

  @Test
  void sweepRunsEachBundleWithEachNumberOfThreadsAndAControl() {
    Cli run = duct("--sizes=8,6 --bundle=4 --bundle=all,2,2 --threads=2 --warm-up=2 --csv");
    assertEquals(0, run.code(), run.err());
    assertEquals("", run.err());
    List<String> csv = run.out().lines().toList();
    List<String> header = List.of(csv.get(0).split(",", -1));
    assertEquals(KEYS, header.subList(0, KEYS.size()));
    assertEquals(1 + 2 * 3 * 2, csv.size()); // sizes, bundles with the control, threads
    assertEquals(1, csv.stream().filter(row -> row.contains(",true,2,")).count(), run.out());
  }

  @Test
  void sweepWritesItsFiles() throws Exception {
    Path result = folder.resolve("result");
    Cli run = duct("--sizes=6 --bundle=3 --bundle=2 --warm-up=2 --threads=2 --output=" + result);
    assertEquals(0, run.code(), run.err());
    assertEquals(new TreeSet<>(List.of("duct.csv", "duct.json", "duct.svg")), names(result));
    String json = Files.readString(result.resolve("duct.json"));
    assertTrue(json.startsWith("[\n{\n") && json.endsWith("}\n]\n"), json);
    var svg =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(result.resolve("duct.svg").toFile());
    assertEquals("svg", svg.getDocumentElement().getTagName());
    assertTrue(svg.getElementsByTagName("path").getLength() + marks(svg) >= 2 * 3);
    assertFalse(Files.exists(machineFile()), "a sweep over chosen bundles stores nothing");
  }

  private static int marks(org.w3c.dom.Document svg) {
    return svg.getElementsByTagName("circle").getLength();
  }

  @Test
  void storedBundleIsTheDefault() {
    assertEquals("\"default\"", json("--size=6 --warm-up=2").get("bundle_origin"));
    DuctSettings settings =
        new DuctSettings(
            VelocitySet.D3Q15, Streaming.IN_PLACE, Storage.DOUBLE, KernelForm.fastest());
    MachineFile file = new MachineFile(host().machineFile(), Assertions::fail);
    assertTrue(file.keepBundle(settings, BundleShape.parse("all,3,2")));
    Map<String, String> json = json("--size=6 --warm-up=2");
    assertEquals("\"6,3,2\"", json.get("bundle"));
    assertEquals("\"stored in " + machineFile() + "\"", json.get("bundle_origin"));
    assertEquals("\"given\"", json("--size=6 --warm-up=2 --bundle=3").get("bundle_origin"));
    assertEquals("\"default\"", json("--size=6 --warm-up=2 --streaming=pull").get("bundle_origin"));
  }

  @Test
  void sweepOfSmallDuctsStoresNothing() {
    Cli small = duct("--sizes=5 --threads=1 --warm-up=2");
    assertEquals(0, small.code(), small.err());
    assertTrue(small.out().contains("stored               no (a duct below 100^3"), small.out());
    Cli not = duct("--sizes=5 --threads=1 --warm-up=2 --no-store");
    assertTrue(not.out().contains("stored               no (--no-store)"), not.out());
    assertFalse(Files.exists(machineFile()));
  }

  @Test
  void wrongMachineFileIsWarnedOfAndIgnored() throws IOException {
    Files.createDirectories(machineFile().getParent());
    Files.writeString(machineFile(), "\\u1");
    Cli run = duct("--size=6 --warm-up=2");
    assertEquals(0, run.code());
    assertTrue(run.out().contains("(default)"), run.out());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().startsWith("hdispatch: warning: machine file must be readable"));
    assertEquals("", duct("--size=6 --warm-up=2 --quiet").err());
    assertEquals("", duct("--size=6 --warm-up=2 --bundle=3").err(), "it is not even read");
  }

  @Test
  void ductThatDoesNotFitIsRefusedWithTheHeapThatIsNeeded() {
    duct("--size=100").assertRefused(5, "heap must hold a duct of 100^3 nodes", "-Xmx");
    duct("--sizes=100,150").assertRefused(5, "a duct of 100^3 nodes", "-Xmx");
  }

  @Test
  void arraysOfMoreThanHalfARegionTakeWholeRegions() {
    double mib = 1 << 20;
    assertEquals(1, DuctHeap.roundedUp(0.4 * mib, 2048 * mib));
    assertEquals(2 / 1.25, DuctHeap.roundedUp(1.25 * mib, 2048 * mib), 1e-12);
    assertEquals(1 / 0.6, DuctHeap.roundedUp(0.6 * mib, 2048 * mib), 1e-12);
    assertEquals(4 / 2.2, DuctHeap.roundedUp(2.2 * mib, 8192 * mib), 1e-12); // regions of 2 or 4
  }

  @Test
  void sizesThatDoNotFitAreLeftOutOfASweep() {
    Cli run = duct("--sizes=100,5 --bundle=5 --threads=1 --warm-up=2");
    assertEquals(0, run.code(), run.err());
    assertEquals(1, run.err().lines().count(), run.err());
    String warning = "hdispatch: warning: size 100 is left out: heap must hold a duct of 100^3";
    assertTrue(run.err().startsWith(warning), run.err());
    assertTrue(run.out().contains("at 5^3"), run.out());
  }

  @Test
  void bundlesThatDoNotFitAreLeftOutOfASweepAndSaidOnce() {
    Cli run = duct("--sizes=32 --bundle=16 --bundle=1 --threads=2 --warm-up=2 --csv");
    assertEquals(0, run.code(), run.err());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().startsWith("hdispatch: warning: 1 at size 32 is left out: heap must"));
    assertEquals(1 + 2 * 2, run.out().lines().count(), run.out());
    duct("--sizes=60 --bundle=1 --warm-up=2 --csv").assertRefused(5, "duct of 60^3 nodes", "-Xmx");
  }

  @Test
  void shapesThatComeToTheSameBundleAreRunOnce() {
    Cli run = duct("--sizes=6 --bundle=10 --bundle=all --bundle=3 --threads=1 --warm-up=2 --csv");
    assertEquals(0, run.code(), run.err());
    List<String> bundles = run.out().lines().filter(row -> row.contains(",false,1.0,")).toList();
    assertEquals(2, bundles.size(), run.out());
    assertTrue(bundles.get(0).contains(",\"6,6,6\",") && bundles.get(0).contains(",10,false,"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--size=8 --bundle=4x4x4",
        "--size=8 --bundle=0",
        "--size=8 --bundle=1,2",
        "--size=8 --bundle=4 --bundle=5",
        "--size=0",
        "--size=5000",
        "--size=x",
        "--size=8 --sizes=9",
        "--size=8 --steps=0",
        "--size=8 --warm-up=0",
        "--size=8 --threads=0",
        "--size=8 --streaming=in_place",
        "--size=8 --storage=half",
        "--size=8 --kernel=none",
        "--size=8 --lattice=D2Q9",
        "--size=8 --no-store",
        "--size=8 --rounds=3",
        "--size=8 --json --csv",
        "--sizes=0",
        "--sizes=8 --steady",
        "--sizes=8 --rounds=0",
        "--sizes=8 --rounds=99999999",
        "--sizes=8 --steps=9999999999",
        "--sizes=8 --warm-up=0",
        "--sizes=,",
        "--sizes=8 --steps=-2",
        "--sizes=8,5000"
      })
  void wrongArgumentsAreRefused(String words) {
    duct(words).assertRefused(2);
  }

  @Test
  void refusalsNameTheValue() {
    duct("--size=8 --bundle=4x4x4")
        .assertRefused(
            2,
            "--bundle must be N or NX,NY,NZ, each a number of nodes or all: --bundle=4x4x4",
            "(see hdispatch duct --help)");
    duct("--size=8 --streaming=aa")
        .assertRefused(2, "--streaming must be one of in-place, pull, push: --streaming=aa");
    duct("--size=0").assertRefused(2, "side of a duct must be 1 to 4096 nodes: side=0");
    duct("--size=8 --steps=-1").assertRefused(2, "steps must number 1 to 10000000: steps=-1");
    duct("--sizes=,").assertRefused(2, "sizes must number at least 1: sizes=0");
    // refused before the heap is looked at, and before anything is run
    duct("--sizes=400 --steps=0").assertRefused(2, "steps=0");
  }

  @Test
  void roundsGiveOneRowARunAllTheSame() {
    Cli run = duct("--sizes=6 --bundle=3 --threads=1 --warm-up=2 --rounds=3 --csv");
    assertEquals(0, run.code(), run.err());
    assertEquals(3, run.out().lines().count()); // header, bundle, control
  }

  @Test
  void progressIsShownOnATerminalOnly() {
    Host terminal = new Host(HEAP, true);
    Object[] one = command("--size=6", "--warm-up=2");
    String shown = Cli.run(terminal, one).err();
    assertTrue(shown.startsWith("\rduct 6^3  step 2 of 4"), shown);
    Object[] sweep = command("--sizes=6", "--bundle=3", "--warm-up=2", "--threads=1");
    shown = Cli.run(terminal, sweep).err();
    assertTrue(shown.startsWith("\rrun 1 of 2  size 6  bundle 3  threads 1  ETA "), shown);
    assertTrue(shown.endsWith("\r"), shown);
    Object[] quiet = command("--size=6", "--warm-up=2", "--quiet");
    assertEquals("", Cli.run(terminal, quiet).err());
  }
}
