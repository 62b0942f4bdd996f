package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class EventsTest {
  private static final int STEPS = 7;

  private static Scheme<long[], Void> scheme() {
    CellMap<long[]> cells =
        CellMap.of(CellGrid.of(5, 1, 1, Ends.OPEN).keys(), KeyOrder.ROW, key -> new long[] {key});
    return Scheme.of(cells)
        .pass("first", (cell, none, tick) -> {})
        .pass(
            "second",
            (cell, none, tick) -> {
              if (tick.step() == 4 && cell[0] == CellKey.of(0, 0, 0)) {
                tick.changes().add(CellKey.of(9, 0, 0));
                tick.changes().add(CellKey.of(8, 0, 0));
              }
            })
        .build();
  }

  @Test
  void recordingSeesStepsPassesAndChangesOfTheCells(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("steps.jfr");
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2);
        Recording recording = new Recording()) {
      TimeLoop loop = dispatcher.loop(scheme());
      recording.enable("org.hdispatch.Step").withoutThreshold();
      recording.enable("org.hdispatch.Pass").withoutThreshold();
      recording.enable("org.hdispatch.CellsChanged").withoutThreshold();
      recording.start();
      loop.run(STEPS);
      recording.stop();
      loop.run(1);
      recording.dump(file);
    }
    List<RecordedEvent> events = RecordingFile.readAllEvents(file);
    List<RecordedEvent> steps = named(events, "org.hdispatch.Step");
    List<RecordedEvent> passes = named(events, "org.hdispatch.Pass");
    List<RecordedEvent> changes = named(events, "org.hdispatch.CellsChanged");
    assertEquals(STEPS, steps.size());
    assertEquals(2 * STEPS, passes.size());
    for (int n = 0; n < STEPS; n++) {
      RecordedEvent step = steps.get(n);
      assertEquals(n, step.getLong("step"));
      assertEquals(n <= 4 ? 5 : 7, step.getInt("cells"));
      for (RecordedEvent pass : passes.subList(2 * n, 2 * n + 2)) {
        assertEquals(n, pass.getLong("step"));
        assertFalse(pass.getStartTime().isBefore(step.getStartTime()));
        assertFalse(pass.getEndTime().isAfter(step.getEndTime()));
      }
      assertEquals("first", passes.get(2 * n).getString("pass"));
      assertEquals("second", passes.get(2 * n + 1).getString("pass"));
    }
    assertEquals(1, changes.size());
    assertEquals(4, changes.get(0).getLong("step"));
    assertEquals(5, changes.get(0).getInt("before"));
    assertEquals(7, changes.get(0).getInt("after"));
  }

  @Test
  void recordingSeesTheStepsInWhichWorkersAllocate(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("growth.jfr");
    CellMap<Object[]> cells =
        CellMap.of(CellGrid.of(2, 1, 1, Ends.OPEN).keys(), KeyOrder.ROW, key -> new Object[1]);
    Scheme<Object[], Void> grows =
        Scheme.of(cells)
            .pass(
                "grow",
                (cell, none, tick) -> {
                  if (tick.step() % 1000 == 500) {
                    cell[0] = new byte[5000];
                  }
                })
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2);
        Recording recording = new Recording()) {
      TimeLoop loop = dispatcher.loop(grows);
      recording.enable("org.hdispatch.Growth").withoutThreshold();
      recording.start();
      loop.run(2000);
      recording.dump(file);
    }
    List<RecordedEvent> growth = named(RecordingFile.readAllEvents(file), "org.hdispatch.Growth");
    for (long step : new long[] {500, 1500}) {
      RecordedEvent event =
          growth.stream().filter(each -> each.getLong("step") == step).findFirst().orElseThrow();
      long bytes = event.getLong("bytes");
      assertTrue(bytes >= 10_000 && bytes < 20_000, "bytes=" + bytes);
    }
    assertTrue(growth.size() < 100, "only where there was any: events=" + growth.size());
  }

  private static List<RecordedEvent> named(List<RecordedEvent> events, String name) {
    return events.stream()
        .filter(event -> event.getEventType().getName().equals(name))
        .sorted((a, b) -> a.getStartTime().compareTo(b.getStartTime()))
        .toList();
  }

  @Test
  void otherRecordingsSeeNone(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("others.jfr");
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2);
        Recording recording = new Recording()) {
      recording.start();
      dispatcher.loop(scheme()).run(STEPS);
      recording.stop();
      recording.dump(file);
    }
    assertTrue(
        RecordingFile.readAllEvents(file).stream()
            .noneMatch(event -> event.getEventType().getName().startsWith("org.hdispatch")));
  }

  /** Once a recording has been, the events' code is another one: still nothing is allocated. */
  @Test
  void costNoByteWhenNotRecorded() {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      try (Recording recording = new Recording()) {
        recording.enable("org.hdispatch.Step");
        recording.start();
        dispatcher.loop(scheme()).run(10);
      }
      TimeLoop loop = dispatcher.loop(scheme());
      assertTrue(loop.warmUp(10_000, 20), () -> loop.stats().toString());
    }
  }
}
