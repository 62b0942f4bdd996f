package org.hdispatch.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

class CellKeyPropertyTest {
  @Property
  void keyGivesItsCoordinatesBack(
      @ForAll @IntRange(min = CellKey.MIN, max = CellKey.MAX) int i,
      @ForAll @IntRange(min = CellKey.MIN, max = CellKey.MAX) int j,
      @ForAll @IntRange(min = CellKey.MIN, max = CellKey.MAX) int k) {
    long key = CellKey.of(i, j, k);
    assertEquals(i, CellKey.i(key));
    assertEquals(j, CellKey.j(key));
    assertEquals(k, CellKey.k(key));
    for (KeyOrder order : KeyOrder.values()) {
      assertEquals(key, order.key(order.code(key)), order.name());
    }
  }
}
