package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class ForksTest {
  private static final long MIB = 1 << 20;

  @TempDir private Path folder;

  @Test
  void smallestHeapIsSomewhatMoreThanWhatLives() throws IOException {
    Forks forks = new Forks(folder, 2);
    SmallestHeap heap =
        new HeapSearch(forks, Jdk.running(), 1.3, "c0de")
            .find(Workload.BANDWIDTH, StudyScope.STANDARD);
    assertEquals(Workload.BANDWIDTH, heap.workload());
    assertEquals(Jdk.running().version(), heap.java());
    long live = 1000L * StudyScope.STANDARD;
    assertTrue(heap.bytes() > live && heap.bytes() < 2 * live, heap::toString);
    assertTrue(folder.toFile().list().length == 0, "files are left");
  }

  @Test
  void jvmThatTakesTooLongIsEnded() throws IOException {
    Forks.Outcome ended =
        new Forks(folder, 2)
            .run(
                new GcCase(
                    Jdk.running().version(),
                    Collector.SERIAL,
                    ScratchPolicy.ENDURING,
                    Workload.BANDWIDTH,
                    StudyScope.STANDARD,
                    6),
                Jdk.running(),
                256 * MIB,
                60,
                60,
                0.5);
    assertEquals("no end within 1 s", ended.why());
    assertTrue(ended.figures().isEmpty());
  }

  @Test
  void jvmThatCannotBeStartedLeavesNothing() throws IOException {
    Path home = Files.createDirectories(folder.resolve("jdk/bin")).getParent();
    Path work = Files.createDirectory(folder.resolve("work"));
    ChildJvm none = new ChildJvm(new Jdk(home, "17.0.15"), work);
    assertThrows(IOException.class, () -> none.knows(List.of()));
    assertEquals(0, work.toFile().list().length);
  }

  @Test
  void whyIsTheFirstLineThatSaysSo() {
    assertEquals(
        "Unrecognized VM option 'UseNoGC'",
        Forks.why(
            List.of(
                "OpenJDK 64-Bit Server VM warning: old",
                "[0.1s][info] gc",
                "Unrecognized VM option 'UseNoGC'",
                "Error: Could not create the Java Virtual Machine."),
            1));
    assertEquals(
        "Error occurred during initialization of VM: Too small maximum heap",
        Forks.why(
            List.of("Error occurred during initialization of VM", "Too small maximum heap"), 1));
    assertEquals("exit code 137", Forks.why(List.of(), 137));
  }
}
