package org.hdispatch.porous.pore;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.hdispatch.cell.Ends;
import org.hdispatch.porous.image.Axis;

/** Percolation against a plain flood fill that carries the winding voxel by voxel. */
class PercolationPropertyTest {

  @Property(tries = 2000, seed = "20110607")
  void agreesWithAPlainFloodFill(
      @ForAll @IntRange(min = 1, max = 7) int nx,
      @ForAll @IntRange(min = 1, max = 7) int ny,
      @ForAll @IntRange(min = 1, max = 7) int nz,
      @ForAll @IntRange(min = 30, max = 80) int percentPore,
      @ForAll long seed,
      @ForAll Axis axis,
      @ForAll Ends sides,
      @ForAll Ends alongAxis) {
    Random random = new Random(seed);
    PoreSpace space = PoreSpace.of(nx, ny, nz, (x, y, z) -> random.nextInt(100) < percentPore);
    Flood flood = new Flood(space, axis, sides, alongAxis);
    Percolation percolation = Percolation.along(space, axis, sides, alongAxis);
    assertEquals(flood.spanning, percolation.spanningClusters());
    int connected = 0;
    for (int i = 0; i < space.voxels(); i++) {
      assertEquals(flood.connected[i], percolation.connected().isPore(i));
      connected += flood.connected[i] ? 1 : 0;
    }
    assertEquals(space.poreVoxels() - connected, percolation.isolatedPoreVoxels());
  }

  private static final class Flood {
    private final PoreSpace space;
    private final boolean[] connected;
    private int spanning;

    Flood(PoreSpace space, Axis axis, Ends sides, Ends alongAxis) {
      this.space = space;
      connected = new boolean[space.voxels()];
      int unseen = Integer.MIN_VALUE;
      int[] winding = new int[space.voxels()];
      Arrays.fill(winding, unseen);
      int[] n = {space.nx(), space.ny(), space.nz()};
      for (int seed = 0; seed < space.voxels(); seed++) {
        if (!space.isPore(seed) || winding[seed] != unseen) {
          continue;
        }
        ArrayDeque<Integer> queue = new ArrayDeque<>();
        ArrayDeque<Integer> cluster = new ArrayDeque<>();
        queue.add(seed);
        winding[seed] = 0;
        boolean first = false;
        boolean last = false;
        boolean winds = false;
        while (!queue.isEmpty()) {
          int at = queue.remove();
          cluster.add(at);
          int[] place = {at % n[0], at / n[0] % n[1], at / n[0] / n[1]};
          first |= place[axis.ordinal()] == 0;
          last |= place[axis.ordinal()] == n[axis.ordinal()] - 1;
          for (int direction = 0; direction < 6; direction++) {
            int d = direction / 2;
            int step = direction % 2 == 0 ? 1 : -1;
            int[] next = place.clone();
            next[d] += step;
            int periods = 0;
            if (next[d] < 0 || next[d] >= n[d]) {
              if ((d == axis.ordinal() ? alongAxis : sides) == Ends.OPEN) {
                continue;
              }
              next[d] = Math.floorMod(next[d], n[d]);
              periods = d == axis.ordinal() ? step : 0;
            }
            int to = this.space.index(next[0], next[1], next[2]);
            if (!space.isPore(to)) {
              continue;
            }
            if (winding[to] == unseen) {
              winding[to] = winding[at] + periods;
              queue.add(to);
            } else {
              winds |= winding[to] != winding[at] + periods;
            }
          }
        }
        if (alongAxis == Ends.OPEN ? first && last : winds) {
          spanning++;
          cluster.forEach(voxel -> connected[voxel] = true);
        }
      }
    }
  }
}
