package org.hdispatch.gc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.opentest4j.AssertionFailedError;

/** What a watch has seen of a JVM against what that JVM itself has logged. */
@Timeout(120)
class CollectorLogTest {
  /** A pause when it is over. */
  private static final Pattern PAUSE =
      Pattern.compile("\\[(\\d+)ns\\].* GC\\(\\d+\\) .*\\bPause .* ([0-9.]+)ms$");

  private static final Pattern SAFEPOINT =
      Pattern.compile("\\[(\\d+)ns\\].*Reaching safepoint: (\\d+) ns,.* Total: (\\d+) ns(,.*)?$");

  private static final double TOLERANCE = 0.02; // relative

  /** The log gives pauses in whole microseconds. */
  private static final double ROUNDING = 500;

  /**
   * G1 and ZGC give log and recorder the same two readings of the clock; Shenandoah's log reads it
   * before and after the recorder (ShenandoahPausePhase of HotSpot), and what lies between is an
   * entry in a list at each end: a microsecond or two, however long the pause.
   */
  private static final double ENTRIES = 4_000;

  /**
   * Parallel begins to record before it logs, and ends later: some 70 microseconds of its work
   * before and after a collection, as seen.
   */
  private static final double WORK = 100_000;

  /** Log and recorder read the clock one after the other at both ends of a safepoint. */
  private static final double READINGS = 12_000;

  /** The machine may take the thread away between two such readings, but not always. */
  private static final int RUNS = 6;

  @TempDir private Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"Serial", "Parallel", "G1", "Z", "Shenandoah"})
  void watchAgreesWithTheLog(String collector) throws IOException, InterruptedException {
    for (int run = 1; run < RUNS; run++) {
      try {
        compare(collector, folder.resolve("gc" + run + ".log"));
        return;
      } catch (AssertionFailedError e) {
        // once more
      }
    }
    compare(collector, folder.resolve("gc.log"));
  }

  private void compare(String collector, Path log) throws IOException, InterruptedException {
    Map<String, String> said = run(collector, log);
    List<Double> pauses = new ArrayList<>(); // ns
    List<Double> stops = new ArrayList<>();
    double reaching = 0;
    for (String line : Files.readAllLines(log)) {
      Matcher pause = PAUSE.matcher(line);
      if (pause.find() && inWindow(pause, said)) {
        pauses.add(1e6 * Double.parseDouble(pause.group(2)));
      }
      Matcher safepoint = SAFEPOINT.matcher(line);
      if (safepoint.find() && inWindow(safepoint, said)) {
        reaching += Double.parseDouble(safepoint.group(2));
        stops.add(Double.parseDouble(safepoint.group(3)));
      }
    }
    assertTrue(pauses.size() >= 3, "pauses logged: " + pauses.size());
    List<Double> seen =
        Arrays.stream(said.get("timeline").split(",")).map(Double::valueOf).toList();
    assertEquals(seen.size(), number(said, "pauses"));
    assertEquals(sum(seen), number(said, "pauseNanos"));
    assertEquals(Collections.max(seen), number(said, "pauseLongestNanos"));
    assertTrue(number(said, "pauseP99Nanos") <= Collections.max(seen));
    switch (collector) {
      case "Serial" -> { // logs two lines for a young collection that turns full
        assertTrue(pauses.size() >= seen.size());
        assertClose(sum(pauses), sum(seen), pauses.size() * ROUNDING);
      }
      case "Parallel" -> assertHold(seen, pauses, WORK);
      case "Shenandoah" -> assertHold(pauses, seen, ENTRIES);
      default -> {
        assertEquals(pauses.size(), seen.size());
        for (int n = 0; n < pauses.size(); n++) {
          assertClose(pauses.get(n), seen.get(n), ROUNDING);
        }
      }
    }
    assertEquals(stops.size(), number(said, "safepoints"));
    assertClose(sum(stops), number(said, "safepointNanos"), stops.size() * READINGS);
    assertClose(reaching, number(said, "reachingNanos"), stops.size() * READINGS);
    assertTrue(number(said, "peakHeapBytes") > 20_000_000, () -> said.get("peakHeapBytes"));
  }

  /**
   * No outer time is shorter than the inner one, and most are no longer than by what is between.
   */
  private static void assertHold(List<Double> outer, List<Double> inner, double between) {
    assertEquals(outer.size(), inner.size());
    int alike = 0;
    for (int n = 0; n < outer.size(); n++) {
      double longer = outer.get(n) - inner.get(n);
      double slack = TOLERANCE * outer.get(n) + ROUNDING;
      assertTrue(longer >= -slack, () -> "shorter by " + -longer + " ns");
      alike += longer <= slack + between ? 1 : 0;
    }
    int most = outer.size() / 2 + 1;
    assertTrue(alike >= most, alike + " of " + outer.size() + " pauses alike");
  }

  private static boolean inWindow(Matcher line, Map<String, String> said) {
    long at = Long.parseLong(line.group(1));
    return at >= Long.parseLong(said.get("begin")) && at < Long.parseLong(said.get("end"));
  }

  private static double number(Map<String, String> said, String key) {
    return Double.parseDouble(said.get(key));
  }

  private static double sum(List<Double> values) {
    return values.stream().mapToDouble(Double::doubleValue).sum();
  }

  private static void assertClose(double logged, double seen, double slack) {
    assertEquals(logged, seen, TOLERANCE * logged + slack);
  }

  /**
   * Runs a JVM of this collector, if there is one. Its log does not tell of pauses as they begin:
   * Shenandoah would count the writing of that line as part of the pause.
   */
  private Map<String, String> run(String collector, Path log)
      throws IOException, InterruptedException {
    Path out = folder.resolve("out.txt");
    String what = collector.equals("Z") ? "gc,gc+phases,safepoint" : "gc,safepoint";
    Process jvm =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+Use" + collector + "GC",
                "-Xms96m",
                "-Xmx96m",
                "-Xlog:" + what + ":file=" + log + ":timenanos,tags:filecount=0",
                "-cp",
                System.getProperty("java.class.path")
                    + File.pathSeparator
                    + System.getProperty("surefire.test.class.path", ""),
                GarbageMaker.class.getName())
            .redirectErrorStream(true)
            .redirectOutput(out.toFile())
            .start();
    int code = jvm.waitFor();
    String text = Files.readString(out);
    assumeTrue(
        code == 0 || !(text.contains("not supported") || text.contains("Unrecognized")), text);
    assertEquals(0, code, text);
    Map<String, String> said = new HashMap<>();
    for (String line : text.lines().toList()) {
      String[] words = line.split(" ");
      if (words.length == 2) {
        said.put(words[0], words[1]);
      }
    }
    return said;
  }
}
