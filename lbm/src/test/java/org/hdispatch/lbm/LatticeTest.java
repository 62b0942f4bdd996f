package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.hdispatch.cell.Ends;
import org.junit.jupiter.api.Test;

class LatticeTest {
  @Test
  void refusesAnEmptyBox() {
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class,
            () -> Lattice.empty(0, 3, 3, Ends.OPEN, Ends.OPEN, Ends.OPEN));
    assertEquals("nodes along an axis must number at least 1: nx=0, ny=3, nz=3", e.getMessage());
  }
}
