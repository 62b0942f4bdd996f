package org.hdispatch.cell;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class CellsTest {
  @Test
  void keyReadsAsATriple() {
    assertEquals("(3, 0, -7)", CellKey.toString(CellKey.of(3, 0, -7)));
    assertEquals("(none)", CellKey.toString(CellKey.NONE));
  }

  @Test
  void refusesCoordinatesThatDoNotFit() {
    assertThrows(IllegalArgumentException.class, () -> CellKey.of(CellKey.MAX + 1, 0, 0));
    assertThrows(IllegalArgumentException.class, () -> CellKey.of(0, 0, CellKey.MIN - 1));
  }

  @Test
  void rowOrderRunsAlongI() {
    long[] keys = CellGrid.of(3, 2, 2, Ends.OPEN).keys();
    long[] shuffled =
        LongStream.of(keys)
            .boxed()
            .sorted((a, b) -> Long.compare(b, a))
            .mapToLong(Long::longValue)
            .toArray();
    assertArrayEquals(keys, KeyOrder.ROW.sorted(shuffled));
    assertEquals(CellKey.of(1, 0, 0), keys[1]);
    assertEquals(CellKey.of(0, 1, 0), keys[3]);
  }

  @Test
  void mortonOrderFillsACubeBeforeItLeavesIt() {
    long[] keys = KeyOrder.MORTON.sorted(CellGrid.of(4, 4, 4, Ends.OPEN).keys());
    for (int n = 0; n < 8; n++) {
      assertTrue(CellKey.i(keys[n]) < 2 && CellKey.j(keys[n]) < 2 && CellKey.k(keys[n]) < 2);
    }
  }

  @ParameterizedTest
  @EnumSource(KeyOrder.class)
  void mapHoldsEveryCellUnderItsKeyInOrder(KeyOrder order) {
    long[] keys = CellGrid.of(5, 3, 2, Ends.OPEN).keys();
    List<Long> made = new ArrayList<>();
    CellMap<String> map =
        CellMap.of(
            keys,
            order,
            key -> {
              made.add(key);
              return CellKey.toString(key);
            });
    assertEquals(keys.length, map.size());
    for (int n = 0; n < map.size(); n++) {
      assertEquals(made.get(n), map.keyAt(n));
      assertSame(map.cellAt(n), map.get(map.keyAt(n)));
    }
    assertArrayEquals(
        keys, LongStream.range(0, map.size()).map(n -> map.keyAt((int) n)).sorted().toArray());
    assertNull(map.get(CellKey.of(5, 0, 0)));
  }

  @Test
  void mapRefusesAKeyTwiceAndACellThatIsMissing() {
    long[] twice = {CellKey.of(1, 1, 1), CellKey.of(1, 1, 1)};
    assertThrows(
        IllegalArgumentException.class, () -> CellMap.of(twice, KeyOrder.ROW, key -> "cell"));
    long[] once = Arrays.copyOf(twice, 1);
    assertThrows(IllegalArgumentException.class, () -> CellMap.of(once, KeyOrder.ROW, key -> null));
  }

  @Test
  void neighboursWrapOnlyOnPeriodicAxes() {
    CellGrid grid = new CellGrid(4, 3, 1, Ends.PERIODIC, Ends.OPEN, Ends.PERIODIC);
    assertEquals(CellKey.of(3, 1, 0), grid.neighbour(CellKey.of(0, 0, 0), -1, 1, 1));
    assertEquals(CellKey.NONE, grid.neighbour(CellKey.of(0, 0, 0), 0, -1, 0));
    assertEquals(CellKey.of(1, 2, 0), grid.neighbour(CellKey.of(1, 2, 0), 4, 0, -3));
  }

  @Test
  void refusesAGridWithoutCells() {
    assertThrows(IllegalArgumentException.class, () -> CellGrid.of(0, 1, 1, Ends.OPEN));
    assertThrows(IllegalArgumentException.class, () -> CellGrid.of(1 << 16, 1 << 16, 2, Ends.OPEN));
  }
}
