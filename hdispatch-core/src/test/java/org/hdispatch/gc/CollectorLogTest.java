package org.hdispatch.gc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
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
  /** A pause when it is over: G1 and others log its begin too, without a time. */
  private static final Pattern PAUSE =
      Pattern.compile("\\[(\\d+)ns\\].* GC\\(\\d+\\) .*\\bPause .* ([0-9.]+)ms$");

  private static final Pattern SAFEPOINT =
      Pattern.compile("\\[(\\d+)ns\\].*Reaching safepoint: (\\d+) ns,.* Total: (\\d+) ns$");

  private static final double TOLERANCE = 0.02; // relative

  /** The log gives pauses in whole microseconds. */
  private static final double ROUNDING = 500;

  /**
   * Log and recorder read the clock one after the other at both ends of a safepoint; so they do for
   * a pause of Shenandoah, whose log counts the keeping of its statistics.
   */
  private static final double READINGS = 12_000;

  /**
   * What one of many pauses may miss of that, the longest above all: its statistics take longer.
   */
  private static final double READINGS_OF_ONE = 5 * READINGS;

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
    Map<String, Long> seen = run(collector, log);
    List<Double> pauses = new ArrayList<>(); // ns
    List<Double> stops = new ArrayList<>();
    double reaching = 0;
    for (String line : Files.readAllLines(log)) {
      Matcher pause = PAUSE.matcher(line);
      if (pause.find() && inWindow(pause, seen)) {
        pauses.add(1e6 * Double.parseDouble(pause.group(2)));
      }
      Matcher safepoint = SAFEPOINT.matcher(line);
      if (safepoint.find() && inWindow(safepoint, seen)) {
        reaching += Double.parseDouble(safepoint.group(2));
        stops.add(Double.parseDouble(safepoint.group(3)));
      }
    }
    assertTrue(pauses.size() >= 3, "pauses logged: " + pauses.size());
    boolean shenandoah = collector.equals("Shenandoah");
    double slack = ROUNDING + (shenandoah ? READINGS : 0);
    assertClose(sum(pauses), seen.get("pauseNanos"), pauses.size() * slack);
    if (collector.equals("Serial")) { // logs two lines for a young collection that turns full
      assertTrue(pauses.size() >= seen.get("pauses"));
      assertTrue(seen.get("pauseLongestNanos") > (1 - TOLERANCE) * Collections.max(pauses));
    } else {
      assertEquals(pauses.size(), seen.get("pauses"));
      assertClose(
          Collections.max(pauses),
          seen.get("pauseLongestNanos"),
          shenandoah ? READINGS_OF_ONE : slack);
    }
    assertEquals(seen.get("pauseNanos"), seen.get("timelineNanos"));
    assertTrue(seen.get("pauseP99Nanos") <= seen.get("pauseLongestNanos"));
    assertEquals(stops.size(), seen.get("safepoints"));
    assertClose(sum(stops), seen.get("safepointNanos"), stops.size() * READINGS);
    assertClose(reaching, seen.get("reachingNanos"), stops.size() * READINGS);
    assertTrue(seen.get("peakHeapBytes") > 20_000_000, () -> "peak " + seen.get("peakHeapBytes"));
  }

  private static boolean inWindow(Matcher line, Map<String, Long> seen) {
    long at = Long.parseLong(line.group(1));
    return at >= seen.get("begin") && at < seen.get("end");
  }

  private static double sum(List<Double> values) {
    return values.stream().mapToDouble(Double::doubleValue).sum();
  }

  private static void assertClose(double logged, double seen, double slack) {
    assertEquals(logged, seen, TOLERANCE * logged + slack);
  }

  /** Runs a JVM of this collector, if there is one. */
  private Map<String, Long> run(String collector, Path log)
      throws IOException, InterruptedException {
    Path out = folder.resolve("out.txt");
    Process jvm =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+Use" + collector + "GC",
                "-Xms96m",
                "-Xmx96m",
                "-Xlog:gc*,safepoint:file=" + log + ":timenanos,tags:filecount=0",
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
    Map<String, Long> figures = new HashMap<>();
    for (String line : text.lines().toList()) {
      String[] words = line.split(" ");
      if (words.length == 2 && words[1].matches("-?\\d+")) {
        figures.put(words[0], Long.parseLong(words[1]));
      }
    }
    return figures;
  }
}
