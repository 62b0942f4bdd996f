package org.hdispatch.app.particles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.hdispatch.app.Cli;
import org.hdispatch.app.console.Host;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SphPeriodicCommandTest {
  /** The keys that programs rely on, in their order. */
  static final List<String> KEYS =
      List.of(
          "particle_steps_per_s",
          "neighbours_mean",
          "pairs_per_s",
          "bytes_per_particle",
          "bytes_per_step",
          "seconds_search",
          "seconds_density",
          "seconds_force",
          "rebuilds",
          "seconds",
          "particles",
          "fluid_particles",
          "cells",
          "threads",
          "search",
          "support",
          "cell_edge",
          "steps",
          "warm_up_steps",
          "form");

  @TempDir Path folder;

  private static Cli periodic(String words) {
    List<String> command = new ArrayList<>(List.of("sph", "periodic"));
    command.addAll(List.of(words.split(" +")));
    return Cli.run(command.toArray());
  }

  private static Map<String, String> json(String words) {
    Cli run = periodic("--warm-up=2 --steps=3 --particles=512 --json " + words);
    assertEquals(0, run.code(), run.err());
    assertEquals("", run.err());
    return run.members();
  }

  private static double number(Map<String, String> json, String key) {
    return Double.parseDouble(json.get(key));
  }

  @Test
  void jsonHasItsKeysInTheirOrder() {
    Map<String, String> json = json("--threads=2 --search=single --form=scalar");
    assertEquals(KEYS, json.keySet().stream().limit(KEYS.size()).toList());
    assertEquals("512", json.get("particles"));
    assertEquals("512", json.get("fluid_particles"));
    assertEquals("8", json.get("cells")); // 8 over a support of 3: two along each axis
    assertEquals("2", json.get("threads"));
    assertEquals("\"single\"", json.get("search"));
    assertEquals("3.0", json.get("support"));
    assertEquals("4.0", json.get("cell_edge"));
    assertEquals("3", json.get("steps"));
    assertEquals("3", json.get("rebuilds"));
    assertEquals("2", json.get("warm_up_steps"));
    assertEquals("\"scalar\"", json.get("form"));
    for (String key : List.of("collector", "collections", "gc_pause_ms", "java", "processors")) {
      assertTrue(json.containsKey(key), key);
    }
  }

  @Test
  void figuresFitTogether() {
    Map<String, String> json = json("--threads=1");
    double speed = number(json, "particle_steps_per_s");
    assertEquals(512 * 3 / number(json, "seconds"), speed, 1e-9 * speed);
    double pairs = speed * number(json, "neighbours_mean");
    assertEquals(pairs, number(json, "pairs_per_s"), 1e-9 * pairs);
    double parts =
        number(json, "seconds_search")
            + number(json, "seconds_density")
            + number(json, "seconds_force");
    assertTrue(0 < parts && parts <= number(json, "seconds"), json.toString());
  }

  /**
   * A simple-cubic lattice, slightly shaken: 92 closer than 3, and 30 at 3 half of which move in.
   */
  @Test
  void neighboursAreThoseWithinTheSupport() {
    for (String search : List.of("verlet", "single", "double")) {
      double mean = number(json("--search=" + search), "neighbours_mean");
      assertEquals(92 + 15, mean, 1);
    }
    assertEquals(80, number(json("--support=2.6"), "neighbours_mean"), 0.1); // r^2 up to 6, shaken
  }

  @Test
  void cellsMayBeLonger() {
    Map<String, String> json = json("--cell-edge=8");
    assertEquals("1", json.get("cells"));
    assertEquals("8.0", json.get("cell_edge"));
  }

  @Test
  void tableTellsWhatAPersonAsksFor() {
    Cli run = periodic("--warm-up=2 --steps=3 --particles=343");
    assertEquals(0, run.code(), run.err());
    for (String word :
        List.of(
            "343 particles (7^3)",
            "quintic spline",
            "within the support of 3 dx, verlet search",
            "MPUPS",
            "million pairs/s (3 steps in",
            "of the time",
            "bytes held a particle",
            "bytes per step",
            "warm-up apart        2 steps")) {
      assertTrue(run.out().contains(word), () -> word + " <- " + run.out());
    }
    assertTrue(run.out().chars().allMatch(c -> c < 128));
  }

  @Test
  void resultGoesIntoTheFolderToo() throws Exception {
    Path result = folder.resolve("result");
    Cli run = periodic("--warm-up=2 --steps=3 --particles=343 --json --output=" + result);
    assertEquals(0, run.code(), run.err());
    assertEquals(run.out(), Files.readString(result.resolve("sph.json")));
  }

  @Test
  void refusalsNameTheValue() {
    periodic("--particles=1001").assertRefused(2, "particles must number a cube: particles=1001");
    periodic("--particles=125")
        .assertRefused(2, "edge of the box must be at least twice the support: edge=5");
    periodic("--particles=512 --cell-edge=3.1")
        .assertRefused(2, "cell edge must be at least the support radius and the skin: edge=3.1");
    periodic("--particles=85184 --cell-edge=22")
        .assertRefused(2, "at most 262144 particles: edge=22.0, particles=287496");
    periodic("--particles=512 --support=2")
        .assertRefused(2, "smoothing length must be long enough");
    periodic("--search=never").assertRefused(2, "--search must be one of double, single, verlet");
    periodic("--form=vector --particles=512 --support=x").assertRefused(2, "--support must be");
    Cli.run("sph", "perodic").assertRefused(2, "did you mean periodic?", "(see hdispatch sph");
    Cli.run("sph").assertRefused(2, "missing required subcommand");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--particles=0",
        "--particles=-8",
        "--particles=x",
        "--support=0",
        "--support=-1",
        "--support=NaN",
        "--steps=0",
        "--warm-up=0",
        "--threads=0",
        "--cell-edge=0",
        "--cell-edge=NaN",
        "--json --csv"
      })
  void wrongArgumentsAreRefused(String words) {
    periodic((words.contains("--particles") ? "" : "--particles=512 ") + words).assertRefused(2);
  }

  @Test
  void progressIsShownOnATerminalOnly() {
    Host terminal = new Host(Runtime.getRuntime().maxMemory(), true);
    Object[] command = {"sph", "periodic", "--particles=343", "--steps=1", "--warm-up=1"};
    assertTrue(Cli.run(terminal, command).err().startsWith("\rperiodic  step 1 of 2"));
  }
}
