package org.hdispatch.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

class CellChangesPropertyTest {
  private static final class Cell {
    long key;

    Cell(long key) {
      this.key = key;
    }
  }

  @Property(tries = 300)
  void mapIsWhatANewMapOfTheseKeysWouldBe(
      @ForAll KeyOrder order, @ForAll boolean reuse, @ForAll long seed) {
    Random random = new Random(seed);
    CellMap<Cell> map = map(order, reuse, randomKeys(random, random.nextInt(20)));
    Map<Long, Cell> model = new HashMap<>();
    for (int n = 0; n < map.size(); n++) {
      model.put(map.keyAt(n), map.cellAt(n));
    }
    CellChanges changes = new CellChanges();
    for (int round = 0; round < 20; round++) {
      long[] additions = randomKeys(random, random.nextInt(30));
      long[] removals = randomKeys(random, random.nextInt(30));
      Set<Long> wanted = new TreeSet<>(model.keySet());
      Arrays.stream(removals).forEach(wanted::remove);
      for (long key : additions) {
        wanted.add(key); // asked for both ways: added
      }
      Arrays.stream(removals).forEach(changes::remove);
      Arrays.stream(additions).forEach(changes::add);
      long revision = map.revision();
      boolean other = !wanted.equals(new TreeSet<>(model.keySet()));
      assertEquals(other, map.apply(changes));
      assertEquals(other ? revision + 1 : revision, map.revision());
      assertTrue(changes.isEmpty());
      check(map, order, model, wanted);
    }
  }

  private static void check(
      CellMap<Cell> map, KeyOrder order, Map<Long, Cell> model, Set<Long> wanted) {
    assertEquals(wanted.size(), map.size());
    List<Long> sorted = wanted.stream().sorted(Comparator.comparingLong(order::code)).toList();
    Set<Long> gone = new TreeSet<>(model.keySet());
    gone.removeAll(wanted);
    for (long key : gone) {
      assertNull(map.get(key));
      assertFalse(map.contains(key));
      model.remove(key);
    }
    for (int n = 0; n < sorted.size(); n++) {
      long key = sorted.get(n);
      assertEquals(key, map.keyAt(n));
      Cell cell = map.cellAt(n);
      assertSame(cell, map.get(key));
      assertEquals(key, cell.key);
      assertSame(cell, model.computeIfAbsent(key, k -> cell), "a cell that stays is the same cell");
    }
    assertEquals(sorted.size(), Set.copyOf(model.values()).size(), "one cell under two keys");
  }

  private static CellMap<Cell> map(KeyOrder order, boolean reuse, long[] keys) {
    return reuse
        ? CellMap.of(keys, order, Cell::new, (cell, key) -> cell.key = key)
        : CellMap.of(keys, order, Cell::new);
  }

  private static long[] randomKeys(Random random, int count) {
    return random
        .ints(count, 0, 64)
        .distinct()
        .mapToLong(n -> CellKey.of(n % 4 - 2, n / 4 % 4 - 1, n / 16 - 3))
        .toArray();
  }

  @Property
  void sortsEachKeyOnceIntoTheOrder(
      @ForAll KeyOrder order, @ForAll @Size(max = 200) List<@IntRange(max = 300) Integer> numbers) {
    long[] keys = numbers.stream().mapToLong(n -> CellKey.of(n % 7, n / 7 % 7, n / 49)).toArray();
    long[] expected = order.sorted(Arrays.stream(keys).distinct().toArray());
    int distinct = order.sortDistinct(keys, keys.length);
    assertEquals(expected.length, distinct);
    for (int n = 0; n < distinct; n++) {
      assertEquals(expected[n], keys[n]);
    }
  }

  @Test
  void noKeyAsksForNothing() {
    CellMap<Cell> map = map(KeyOrder.ROW, false, new long[] {CellKey.of(1, 2, 3)});
    CellChanges changes = new CellChanges();
    changes.add(CellKey.NONE);
    changes.remove(CellKey.NONE);
    assertTrue(changes.isEmpty());
    changes.add(CellKey.of(1, 2, 3));
    changes.remove(CellKey.of(0, 0, 0));
    assertFalse(map.apply(changes));
    assertEquals(0, map.revision());
  }

  @Test
  void staysAsItWasIfACellCannotBeMade() {
    long[] keys = CellGrid.of(3, 1, 1, Ends.OPEN).keys();
    CellMap<Cell> map =
        CellMap.of(keys, KeyOrder.ROW, key -> CellKey.i(key) == 5 ? null : new Cell(key));
    CellChanges changes = new CellChanges();
    changes.remove(CellKey.of(1, 0, 0));
    changes.add(CellKey.of(4, 0, 0));
    changes.add(CellKey.of(5, 0, 0));
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> map.apply(changes));
    assertEquals("cell must exist: key=(5, 0, 0)", e.getMessage());
    assertTrue(changes.isEmpty());
    assertEquals(3, map.size());
    assertEquals(0, map.revision());
    assertTrue(map.contains(CellKey.of(1, 0, 0)));
    assertFalse(map.contains(CellKey.of(4, 0, 0)));
    changes.add(CellKey.of(4, 0, 0));
    assertTrue(map.apply(changes));
    assertEquals(4, map.size());
  }

  @Test
  void staysAsItWasIfACellCannotBeRenewed() {
    CellMap<Cell> map =
        CellMap.of(
            CellGrid.of(3, 1, 1, Ends.OPEN).keys(),
            KeyOrder.ROW,
            Cell::new,
            (cell, key) -> {
              if (CellKey.i(key) == 5) {
                throw new ArithmeticException("on purpose");
              }
              cell.key = key;
            });
    CellChanges changes = new CellChanges();
    changes.remove(CellKey.of(1, 0, 0));
    assertTrue(map.apply(changes));
    changes.add(CellKey.of(5, 0, 0));
    assertThrows(ArithmeticException.class, () -> map.apply(changes));
    assertEquals(2, map.size());
    assertEquals(1, map.revision());
    changes.add(CellKey.of(4, 0, 0));
    assertTrue(map.apply(changes));
    assertEquals(CellKey.of(4, 0, 0), map.get(CellKey.of(4, 0, 0)).key);
  }

  @Test
  void fixedCellsAndKeysOfNoCellAreRefused() {
    CellMap<Cell> map =
        CellMap.fixed(CellGrid.of(3, 1, 1, Ends.OPEN).keys(), KeyOrder.ROW, Cell::new);
    CellChanges changes = new CellChanges();
    changes.add(CellKey.of(4, 0, 0));
    assertThrows(IllegalStateException.class, () -> map.apply(changes));
    assertEquals(3, map.size());
    assertThrows(IllegalArgumentException.class, () -> changes.add(-7));
    assertThrows(IllegalArgumentException.class, () -> changes.remove(-7));
    assertThrows(
        IllegalArgumentException.class,
        () -> CellMap.of(new long[] {CellKey.NONE}, KeyOrder.MORTON, Cell::new));
  }
}
