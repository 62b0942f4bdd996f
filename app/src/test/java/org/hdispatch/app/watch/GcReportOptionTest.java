package org.hdispatch.app.watch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.jr.ob.JSON;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.hdispatch.app.Cli;
import org.hdispatch.gc.GcWatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GcReportOptionTest {
  @TempDir Path folder;

  private static Cli run(String words, Path report) {
    List<Object> command = new ArrayList<>(List.of(words.split(" ")));
    command.add("--gc-report=" + report);
    command.add("--threads=2");
    return Cli.run(command.toArray());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "duct --size=8 --steps=20 --warm-up=10",
        "sph periodic --particles=343 --steps=5 --warm-up=5",
        "sph couette --size=8 --time=0.001",
        "settle --fluid=e4 --nodes-across=3",
        "permeability --spheres=sc --size=12"
      })
  void everyRunTellsOnItself(String words) throws IOException {
    Path file = folder.resolve("gc.json");
    Cli run = run(words, file);
    assertEquals(0, run.code(), run.err());
    assertTrue(run.out().contains("collector            " + GcWatch.collector()), run.out());
    assertTrue(run.out().contains(" ms, stopped "), run.out());
    assertTrue(run.out().contains(" bytes per step (worst worker)"), run.out());
    Map<String, Object> report = JSON.std.mapFrom(Files.readString(file));
    assertEquals(2, ((List<?>) report.get("workers")).size());
    List<Object> windows = new ArrayList<>();
    for (Object each : (List<?>) report.get("windows")) {
      Map<?, ?> window = (Map<?, ?>) each;
      windows.add(window.get("window"));
      assertEquals(
          ((Number) ((Map<?, ?>) window.get("pauses")).get("count")).intValue(),
          ((List<?>) window.get("timeline")).size());
    }
    boolean warmedUp = ((Number) report.get("warm_up_steps")).longValue() > 0;
    assertEquals( // the shortest of these runs are over before they are warm
        warmedUp
            ? List.of("set-up", "warm-up", "steps", "rest")
            : List.of("set-up", "steps", "rest"),
        windows);
    assertTrue(warmedUp || words.startsWith("settle") || words.startsWith("permeability"));
    assertTrue(((Number) report.get("steps")).longValue() > 0);
    assertTrue(((Number) ((Map<?, ?>) report.get("heap")).get("most_bytes")).longValue() > 0);
    assertTrue(((Map<?, ?>) report.get("jvm")).get("arguments") instanceof List);
  }

  @Test
  void fileThatCannotBeWrittenIsRefusedBeforeAnythingIsComputed() {
    Path nowhere = folder.resolve("missing/gc.json");
    // a run of hours, were it begun
    run("duct --size=100 --steps=10000000", nowhere).assertRefused(3, "gc.json");
    run("sph periodic --particles=27000 --steps=100000000", nowhere).assertRefused(3, "gc.json");
    run("sph couette", nowhere).assertRefused(3, "gc.json");
    run("settle", nowhere).assertRefused(3, "gc.json");
    run("permeability --spheres=sc", nowhere).assertRefused(3, "gc.json");
    run("duct --size=8", folder).assertRefused(3, "must not be a directory");
    assertFalse(Files.exists(nowhere.getParent()));
  }

  @Test
  void sweepHasNoReport() {
    run("duct --sizes=6", folder.resolve("gc.json"))
        .assertRefused(2, "--gc-report must come with --size");
  }
}
