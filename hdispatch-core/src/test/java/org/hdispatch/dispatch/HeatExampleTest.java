package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.junit.jupiter.api.Test;

/** The README's example: heat conduction by finite differences, one block of nodes a cell. */
class HeatExampleTest {
  private static final int N = 8;
  private static final int BLOCKS = 3;
  private static final double R = 0.1; // alpha dt / dx², stable below 1/6

  /** N³ nodes, previous and current temperature. */
  record Block(long key, double[][] temperature) {}

  @Test
  void readmeShowsThisExample() throws IOException {
    Path root = Path.of("").toAbsolutePath();
    while (!Files.exists(root.resolve("settings.gradle"))) {
      root = root.getParent();
    }
    String readme = Files.readString(root.resolve("README.md"));
    String source =
        Files.readString(
            root.resolve(
                "hdispatch-core/src/test/java/org/hdispatch/dispatch/HeatExampleTest.java"));
    String example =
        source.substring(source.lastIndexOf("// [README") + 10, source.lastIndexOf("// README]"));
    assertTrue(
        readme.replaceAll("\\s", "").contains(example.replaceAll("\\s", "")),
        "README.md must show the example as it is compiled here");
  }

  @Test
  void sineDecaysAtTheRateOfTheDifferenceScheme() {
    CellGrid grid = CellGrid.of(BLOCKS, BLOCKS, BLOCKS, Ends.PERIODIC);
    CellMap<Block> blocks =
        CellMap.of(grid.keys(), KeyOrder.MORTON, key -> new Block(key, new double[2][N * N * N]));
    int length = N * BLOCKS;
    for (int b = 0; b < blocks.size(); b++) {
      Block block = blocks.cellAt(b);
      for (int n = 0; n < N * N * N; n++) {
        int x = CellKey.i(block.key()) * N + n % N;
        block.temperature()[0][n] = Math.sin(2 * Math.PI * x / length);
      }
    }
    long steps = 200;
    int newest;
    // [README
    Scheme<Block, double[]> heat =
        Scheme.of(blocks)
            .scratch(() -> new double[(N + 2) * (N + 2) * (N + 2)]) // once per enduring thread
            .pass(
                "conduct",
                (block, halo, tick) -> {
                  gather(grid, blocks, block, tick.previous(), halo); // anyone's previous values
                  conduct(halo, block.temperature()[tick.current()]); // this block's current values
                })
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(heat);
      loop.run(steps);
      System.out.println(loop.stats());
      // README]
      assertEquals(steps, loop.stats().steps());
      newest = loop.tick().previous();
    }
    // One step multiplies the sine by 1 - 2 R (1 - cos(2 pi / length)).
    double decay = Math.pow(1 - 2 * R * (1 - Math.cos(2 * Math.PI / length)), steps);
    double worst = 0;
    for (int b = 0; b < blocks.size(); b++) {
      Block block = blocks.cellAt(b);
      for (int n = 0; n < N * N * N; n++) {
        int x = CellKey.i(block.key()) * N + n % N;
        double exact = decay * Math.sin(2 * Math.PI * x / length);
        worst = Math.max(worst, Math.abs(block.temperature()[newest][n] - exact));
      }
    }
    assertTrue(worst < 1e-13, "round-off only: error=" + worst);
  }

  private static void gather(
      CellGrid grid, CellMap<Block> blocks, Block block, int previous, double[] halo) {
    copy(block.temperature()[previous], halo, 0, 0, 0);
    for (int side = -1; side <= 1; side += 2) {
      copy(beside(grid, blocks, block, side, 0, 0).temperature()[previous], halo, side, 0, 0);
      copy(beside(grid, blocks, block, 0, side, 0).temperature()[previous], halo, 0, side, 0);
      copy(beside(grid, blocks, block, 0, 0, side).temperature()[previous], halo, 0, 0, side);
    }
  }

  private static Block beside(
      CellGrid grid, CellMap<Block> blocks, Block block, int di, int dj, int dk) {
    return blocks.get(grid.neighbour(block.key(), di, dj, dk));
  }

  /** Copies what of a block at (di, dj, dk) lies within the halo. */
  private static void copy(double[] from, double[] halo, int di, int dj, int dk) {
    for (int z = first(dk); z <= last(dk); z++) {
      for (int y = first(dj); y <= last(dj); y++) {
        for (int x = first(di); x <= last(di); x++) {
          halo[halo(x + di * N, y + dj * N, z + dk * N)] = from[x + N * (y + N * z)];
        }
      }
    }
  }

  private static int first(int d) {
    return d < 0 ? N - 1 : 0;
  }

  private static int last(int d) {
    return d > 0 ? 0 : N - 1;
  }

  private static int halo(int x, int y, int z) {
    return x + 1 + (N + 2) * (y + 1 + (N + 2) * (z + 1));
  }

  private static void conduct(double[] halo, double[] current) {
    for (int z = 0; z < N; z++) {
      for (int y = 0; y < N; y++) {
        for (int x = 0; x < N; x++) {
          double here = halo[halo(x, y, z)];
          double around =
              halo[halo(x - 1, y, z)]
                  + halo[halo(x + 1, y, z)]
                  + halo[halo(x, y - 1, z)]
                  + halo[halo(x, y + 1, z)]
                  + halo[halo(x, y, z - 1)]
                  + halo[halo(x, y, z + 1)];
          current[x + N * (y + N * z)] = here + R * (around - 6 * here);
        }
      }
    }
  }
}
