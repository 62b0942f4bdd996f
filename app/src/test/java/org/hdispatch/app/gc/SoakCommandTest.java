package org.hdispatch.app.gc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hdispatch.app.Cli;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SoakCommandTest {
  @TempDir Path folder;

  private static Cli soak(String words) {
    List<Object> command = new ArrayList<>(List.of("soak"));
    command.addAll(List.of(words.split(" ")));
    return Cli.run(command.toArray());
  }

  private static long figure(Cli run, String key) {
    Matcher matcher = Pattern.compile("\"" + key + "\": (\\d+)").matcher(run.out());
    assertTrue(matcher.find(), run.out());
    return Long.parseLong(matcher.group(1));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--method=lbm --steps=10000 --warm-up=3000",
        "--method=sph --steps=1000 --warm-up=1000"
      })
  void steppingLeavesNothingToTheCollector(String words) {
    Cli run = soak(words + " --collectors=epsilon,g1 --threads=2");
    assertEquals(0, run.code(), run.out() + run.err());
    List<String> lines = run.out().lines().toList();
    assertEquals(2, lines.size(), run.out());
    for (String line : lines) {
      String nothing = " 0 collections, 0 safepoints of the collector (";
      assertTrue(line.contains(nothing) && line.endsWith(": passed"), line);
    }
    assertTrue(lines.get(0).contains(" Epsilon "), run.out());
    assertEquals("", run.err());
  }

  @Test
  void scratchMadeForEachCellFillsEpsilon() {
    Cli run =
        soak(
            "--method=lbm --steps=4000 --warm-up=1000 --collectors=epsilon --scratch=per-cell"
                + " --json");
    assertEquals(4, run.code(), run.out() + run.err());
    assertTrue(run.out().contains("\"failed\""), run.out());
    assertTrue(run.out().contains("OutOfMemoryError"), run.out());
    assertTrue(run.out().contains("\"collections\": null"), run.out());
  }

  /** Also that the log of this JVM is understood. */
  @ParameterizedTest
  @ValueSource(strings = {"serial", "g1"})
  void scratchMadeForEachCellIsCollectedBy(String collector) {
    Cli run =
        soak(
            "--method=lbm --steps=4000 --warm-up=1000 --scratch=per-cell --json --collectors="
                + collector);
    assertEquals(4, run.code(), run.out() + run.err());
    assertTrue(figure(run, "collections") > 0, run.out());
    // one by one, but for what comes of a concurrent cycle
    assertTrue(figure(run, "collector_safepoints") >= figure(run, "collections"), run.out());
    assertTrue(figure(run, "bytes") > 4000, run.out());
    assertEquals(0, figure(run, "percent_without_bytes"));
    assertEquals("hdispatch: soak must leave nothing to the collector: see above\n", run.err());
  }

  @Test
  void filesHoldEveryRun() throws IOException {
    Path output = folder.resolve("out");
    Cli run =
        soak("--method=lbm --steps=100 --warm-up=9 --collectors=serial --csv --output=" + output);
    assertTrue(run.code() == 0 || run.code() == 4, run.err()); // hardly warmed up
    assertEquals(run.out(), Files.readString(output.resolve("soak.csv")));
    assertEquals(2, run.out().lines().count());
    assertTrue(Files.readString(output.resolve("soak.json")).contains("\"heap_bytes\": "));
  }

  @Test
  void jdkMustBeThere() {
    soak("--jdk=" + folder).assertRefused(2, "--jdk must be a home of Java 17 or newer: " + folder);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--steps=0",
        "--steps=9999999999",
        "--warm-up=0",
        "--threads=0",
        "--method=dem",
        "--collectors=cms",
        "--scratch=short",
        "--json --csv"
      })
  void wrongArgumentsAreRefused(String words) {
    soak(words).assertRefused(2);
  }
}
