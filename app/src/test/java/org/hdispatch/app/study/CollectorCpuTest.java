package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CollectorCpuTest {
  @TempDir private Path tasks;

  private void task(String id, String name, long nanos) throws IOException {
    Path task = Files.createDirectory(tasks.resolve(id));
    Files.writeString(task.resolve("comm"), name + "\n");
    Files.writeString(task.resolve("schedstat"), nanos + " 4711 12\n");
  }

  @Test
  void countsTheThreadsThatCollectAndNoOthers() throws IOException {
    task("1", "java", 1);
    task("2", "VM Thread", 20);
    task("3", "VM Periodic Tas", 300);
    task("4", "GC Thread#0", 4_000);
    task("5", "G1 Conc#0", 50_000);
    task("6", "C2 CompilerThre", 600_000);
    task("7", "ZWorkerYoung#0", 7_000_000);
    task("8", "Shenandoah GC T", 80_000_000);
    task("9", "gc-study-enduri", 900_000_000);
    assertEquals(87_054_020, CollectorCpu.nanos(tasks));
  }

  @Test
  void whatTheSystemDoesNotTellIsNotKnown() throws IOException {
    assertEquals(-1, CollectorCpu.nanos(tasks.resolve("none")));
    Files.writeString(Files.createDirectory(tasks.resolve("1")).resolve("comm"), "VM Thread\n");
    assertEquals(-1, CollectorCpu.nanos(tasks));
  }

  @Test
  void collectionsOfThisJvmTakeTime() {
    long before = CollectorCpu.nanos();
    assumeTrue(before >= 0, "needs Linux with statistics of its scheduler");
    for (int n = 0; n < 10; n++) {
      System.gc();
    }
    assertTrue(CollectorCpu.nanos() - before > 1_000_000); // 10 full collections of some MB
  }
}
