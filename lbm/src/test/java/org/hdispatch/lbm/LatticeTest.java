package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.cell.Ends;
import org.junit.jupiter.api.Test;

class LatticeTest {
  @Test
  void goesOnBeyondPeriodicEndsOnly() {
    Lattice box =
        new Lattice(3, 2, 1, Ends.PERIODIC, Ends.OPEN, Ends.PERIODIC, (x, y, z) -> x == 2);
    assertTrue(box.fluid(2, 0, 0));
    assertFalse(box.fluid(0, 0, 0));
    assertTrue(box.fluid(-1, 1, 0));
    assertTrue(box.fluid(5, 0, -7));
    assertFalse(box.fluid(3, 0, 0));
    assertFalse(box.fluid(2, -1, 0));
    assertFalse(box.fluid(2, 2, 0));
  }

  @Test
  void refusesABoxWithoutEndsOrNodes() {
    NodeMap nodes = (x, y, z) -> true;
    assertThrows(
        NullPointerException.class, () -> new Lattice(3, 3, 3, Ends.OPEN, null, Ends.OPEN, nodes));
    assertThrows(
        NullPointerException.class,
        () -> new Lattice(3, 3, 3, Ends.OPEN, Ends.OPEN, Ends.OPEN, null));
  }

  @Test
  void refusesAnEmptyBox() {
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class,
            () -> Lattice.empty(0, 3, 3, Ends.OPEN, Ends.OPEN, Ends.OPEN));
    assertEquals("nodes along an axis must number at least 1: nx=0, ny=3, nz=3", e.getMessage());
  }
}
