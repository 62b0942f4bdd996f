package org.hdispatch.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.gc.AllocationMeter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Counts every byte, so it has no string constant: when HotSpot's C2 is asked to compile a method,
 * the thread that asks makes all string constants of the method's class that are not there yet.
 */
class CellChangesAllocationTest {
  private static final class Cell {
    long key;

    Cell(long key) {
      this.key = key;
    }
  }

  /** A front of constant or breathing size; the marks of removed keys would fill the map often. */
  @ParameterizedTest
  @ValueSource(ints = {0, 40, 90})
  @SuppressWarnings("deprecation") // threadId() needs Java 19
  void allocatesNothingOnceGrown(int breath) {
    CellMap<Cell> map =
        CellMap.of(
            CellGrid.of(100, 2, 1, Ends.OPEN).keys(),
            KeyOrder.MORTON,
            Cell::new,
            (cell, key) -> cell.key = key);
    AllocationMeter meter = new AllocationMeter(Thread.currentThread().getId());
    long[] before = new long[1];
    long[] after = new long[1];
    CellChanges changes = new CellChanges();
    int head = 100;
    int tail = 0;
    boolean quiet = false;
    for (int round = 0; round < 10 || round < 60 && !quiet; round++) {
      meter.read(before);
      for (int step = 0; step < 1_000; step++) {
        int length = 100 - breath * (step / 10 % 2);
        head += step % 3;
        for (int i = head - step % 3; i < head; i++) {
          changes.add(CellKey.of(i, 0, 0));
          changes.add(CellKey.of(i, 1, 0));
        }
        for (; tail < head - length; tail++) {
          changes.remove(CellKey.of(tail, 0, 0));
          changes.remove(CellKey.of(tail, 1, 0));
        }
        for (; tail > head - length; tail--) {
          changes.add(CellKey.of(tail - 1, 0, 0));
          changes.add(CellKey.of(tail - 1, 1, 0));
        }
        map.apply(changes);
        assertTrue(map.contains(CellKey.of(head - 1, 1, 0)));
        assertEquals(2 * length, map.size());
      }
      meter.read(after);
      quiet = after[0] == before[0];
    }
    assertTrue(quiet, "bytes=" + (after[0] - before[0]));
  }
}
