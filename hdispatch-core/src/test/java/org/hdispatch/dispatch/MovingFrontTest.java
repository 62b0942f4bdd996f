package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.LongFunction;
import org.hdispatch.cell.CellChanges;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Cells that come and go: spiral waves of an excitable medium (Greenberg and Hastings, 1978) where
 * only excited and refractory sites are cells. An excited cell wants its four neighbours; a cell
 * that has recovered wants to go. Compared with the same rule on plain sorted maps.
 */
class MovingFrontTest {
  private static final CellGrid GRID =
      new CellGrid(40, 32, 1, Ends.PERIODIC, Ends.PERIODIC, Ends.OPEN);
  private static final int RECOVERED = 6;

  /** A site that is not at rest; age 1 is excited. */
  private static final class Site {
    long key;
    final int[] age = new int[2];
    final double[] value = new double[2];

    Site(long key) {
      renew(key);
    }

    void renew(long newKey) {
      key = newKey;
      age[0] = 1;
      age[1] = 1;
      value[0] = 1.0 / (3 + CellKey.i(key));
      value[1] = value[0];
    }
  }

  /** A broken wave: its end curls up into a spiral that never dies. */
  private static long[] keysAtStart() {
    long[] keys = new long[4 * 16];
    for (int n = 0; n < keys.length; n++) {
      keys[n] = CellKey.of(17 + n % 4, n / 4, 0);
    }
    return keys;
  }

  private static int ageAtStart(long key) {
    return 21 - CellKey.i(key);
  }

  private static CellMap<Site> sitesAtStart(KeyOrder order) {
    CellMap<Site> sites = CellMap.of(keysAtStart(), order, Site::new, Site::renew);
    for (int n = 0; n < sites.size(); n++) {
      sites.cellAt(n).age[0] = ageAtStart(sites.keyAt(n));
    }
    return sites;
  }

  private static void step(Site site, int previous, LongFunction<Site> at) {
    double sum = site.value[previous];
    for (int side = 0; side < 4; side++) {
      Site near = at.apply(neighbour(site.key, side));
      sum = sum * 0.7 + (near == null ? 0.1 : near.value[previous]) / (2 + side);
    }
    site.value[previous ^ 1] = sum;
    site.age[previous ^ 1] = site.age[previous] + 1;
  }

  private static boolean excited(Site site, int previous) {
    return site.age[previous] == 1;
  }

  private static boolean recovered(Site site, int previous) {
    return site.age[previous] + 1 >= RECOVERED;
  }

  private static long neighbour(long key, int side) {
    return switch (side) {
      case 0 -> GRID.neighbour(key, -1, 0, 0);
      case 1 -> GRID.neighbour(key, 1, 0, 0);
      case 2 -> GRID.neighbour(key, 0, -1, 0);
      default -> GRID.neighbour(key, 0, 1, 0);
    };
  }

  private static Scheme<Site, Void> scheme(CellMap<Site> sites) {
    LongFunction<Site> at = sites::get;
    return Scheme.of(sites)
        .pass(
            "excite",
            (site, none, tick) -> {
              step(site, tick.previous(), at);
              if (excited(site, tick.previous())) {
                for (int side = 0; side < 4; side++) {
                  tick.changes().add(neighbour(site.key, side));
                }
              }
              if (recovered(site, tick.previous())) {
                tick.changes().remove(site.key);
              }
            })
        .build();
  }

  private static double[] values(CellMap<Site> sites, int previous) {
    double[] all = new double[2 * sites.size()];
    for (int n = 0; n < sites.size(); n++) {
      all[2 * n] = sites.keyAt(n);
      all[2 * n + 1] = sites.cellAt(n).value[previous];
    }
    return all;
  }

  /** The same rule without any of ours but the grid. */
  private static double[] onSortedMaps(int steps) {
    TreeMap<Long, Site> sites = new TreeMap<>();
    for (long key : keysAtStart()) {
      Site site = new Site(key);
      site.age[0] = ageAtStart(key);
      sites.put(key, site);
    }
    for (int n = 0; n < steps; n++) {
      int previous = n & 1;
      Set<Long> added = new HashSet<>();
      Set<Long> removed = new HashSet<>();
      for (Site site : sites.values()) {
        step(site, previous, sites::get);
        for (int side = 0; side < 4 && excited(site, previous); side++) {
          added.add(neighbour(site.key, side));
        }
        if (recovered(site, previous)) {
          removed.add(site.key);
        }
      }
      removed.removeAll(added);
      sites.keySet().removeAll(removed);
      added.forEach(key -> sites.computeIfAbsent(key, Site::new));
    }
    double[] all = new double[2 * sites.size()];
    int n = 0;
    for (Map.Entry<Long, Site> entry : sites.entrySet()) {
      all[n++] = entry.getKey();
      all[n++] = entry.getValue().value[steps & 1];
    }
    return all;
  }

  @ParameterizedTest
  @CsvSource({"1, PULL", "2, PULL", "3, PULL", "5, PULL", "2, STATIC", "3, HEAVIEST_FIRST"})
  void sameCellsAndBitsAsOnSortedMaps(int workers, Handout handout) {
    CellMap<Site> sites = sitesAtStart(KeyOrder.ROW);
    try (Dispatcher dispatcher = Dispatcher.builder().workers(workers).handout(handout).build()) {
      TimeLoop loop = dispatcher.loop(scheme(sites));
      for (int steps : new int[] {1, 2, 30, 301}) {
        loop.run(steps - loop.tick().step());
        assertArrayEquals(onSortedMaps(steps), values(sites, loop.tick().previous()));
      }
    }
    assertTrue(sites.revision() > 290, "the wave must not rest: changes=" + sites.revision());
  }

  @ParameterizedTest
  @CsvSource({"1, PULL, ROW", "2, PULL, MORTON", "2, HEAVIEST_FIRST, ROW"})
  void allocatesNothingOnceGrown(int workers, Handout handout, KeyOrder order) {
    CellMap<Site> sites = sitesAtStart(order);
    try (Dispatcher dispatcher = Dispatcher.builder().workers(workers).handout(handout).build()) {
      TimeLoop loop = dispatcher.loop(scheme(sites));
      loop.run(5_000);
      long unchanged = loop.tick().step() - sites.revision();
      assertTrue(loop.warmUp(2_000, 20), () -> loop.stats().toString());
      assertEquals(unchanged, loop.tick().step() - sites.revision(), "cells change in every step");
    }
  }

  @Test
  void aStepThatFailsChangesNoCells() {
    CellMap<Site> sites = sitesAtStart(KeyOrder.ROW);
    Scheme<Site, Void> failing =
        Scheme.of(sites)
            .pass(
                "wish",
                (site, none, tick) -> {
                  tick.changes().remove(site.key);
                  if (tick.step() == 0 && CellKey.j(site.key) == 9) {
                    throw new ArithmeticException("on purpose");
                  }
                })
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(failing);
      assertThrows(KernelException.class, () -> loop.run(1));
      assertEquals(64, sites.size());
      assertEquals(0, sites.revision());
      dispatcher.loop(scheme(sites)).run(1);
      assertEquals(1, sites.revision());
      assertArrayEquals(onSortedMaps(1), values(sites, 1));
    }
  }

  @Test
  void cellsChangedBetweenRunsAreHandedOut() {
    CellMap<Site> sites = sitesAtStart(KeyOrder.ROW);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop =
          dispatcher.loop(
              Scheme.of(sites)
                  .beforeStep(tick -> tick.changes().add(CellKey.of(30, 0, (int) tick.step())))
                  .pass("count", (site, none, tick) -> site.value[0]++)
                  .build());
      CellChanges changes = new CellChanges();
      changes.add(CellKey.of(0, 31, 0));
      sites.apply(changes);
      loop.run(1); // 65 cells; one more afterwards
      assertEquals(65, loop.stats().workers().stream().mapToLong(w -> w.cells()).sum());
      loop.run(1);
      assertEquals(65 + 66, loop.stats().workers().stream().mapToLong(w -> w.cells()).sum());
      assertEquals(67, sites.size());
    }
  }
}
