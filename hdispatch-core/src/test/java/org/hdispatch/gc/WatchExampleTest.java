package org.hdispatch.gc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;
import org.junit.jupiter.api.Test;

/** The example of hdispatch-core/README.md: how an embedder watches its own loop. */
class WatchExampleTest {
  @Test
  void readmeShowsThisExample() throws IOException {
    Path root = Path.of("").toAbsolutePath();
    while (!Files.exists(root.resolve("settings.gradle"))) {
      root = root.getParent();
    }
    Path core = root.resolve("hdispatch-core");
    String readme = Files.readString(core.resolve("README.md"));
    String source =
        Files.readString(core.resolve("src/test/java/org/hdispatch/gc/WatchExampleTest.java"));
    String example =
        source.substring(source.lastIndexOf("// [README") + 10, source.lastIndexOf("// README]"));
    assertTrue(
        readme.replaceAll("\\s", "").contains(example.replaceAll("\\s", "")),
        "README.md must show the example as it is compiled here");
  }

  @Test
  void countsWhatAKernelLeaves() {
    CellGrid grid = CellGrid.of(4, 4, 4, Ends.OPEN);
    CellMap<double[][]> cells = CellMap.of(grid.keys(), KeyOrder.ROW, key -> new double[1][]);
    Scheme<double[][], Object> wasteful =
        Scheme.of(cells)
            .scratch(Object::new)
            .pass("waste", (cell, scratch, tick) -> cell[0] = new double[100])
            .build();
    long warmUp = 10;
    long steps = 100;
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = dispatcher.loop(wasteful);
      // [README
      AllocationMeter meter = new AllocationMeter(Thread.currentThread().getId());
      long[] before = new long[meter.threads()];
      long[] after = new long[meter.threads()];
      try (GcWatch watch = GcWatch.start()) {
        loop.run(warmUp);
        loop.resetStats();
        watch.mark();
        meter.read(before);
        loop.run(steps);
        meter.read(after);
        List<GcReport> windows = watch.stop(); // [0] warm-up, [1] the steps after it
        System.out.println(windows.get(1));
        System.out.println(loop.stats()); // with the bytes per step of the worst worker
        System.out.println(after[0] - before[0] + " bytes on this thread, exactly");
      }
      // README]
      long least = steps * cells.size() * 100 * Double.BYTES;
      assertTrue(after[0] - before[0] >= least, "bytes=" + (after[0] - before[0]));
      assertTrue(loop.stats().bytesPerStep() >= least / steps, loop.stats().toString());
      assertEquals(steps, loop.stats().steps());
    }
  }
}
