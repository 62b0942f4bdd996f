package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.cell.Ends;
import org.junit.jupiter.api.Test;

class LatticeTest {
  /** A box of 3 x 3 x 3 whose fluid nodes are listed as xyz digits. */
  private static Lattice fluid(String... nodes) {
    return new Lattice(
        3,
        3,
        3,
        Ends.OPEN,
        Ends.OPEN,
        Ends.OPEN,
        (x, y, z) -> {
          for (String node : nodes) {
            if (node.equals("" + x + y + z)) {
              return true;
            }
          }
          return false;
        });
  }

  @Test
  void faceLinkIsOpenBetweenFluidNodes() {
    assertTrue(fluid("000", "100").open(0, 0, 0, 1, 0, 0));
    assertFalse(fluid("000").open(0, 0, 0, 1, 0, 0));
    assertFalse(fluid("000").open(0, 0, 0, -1, 0, 0));
  }

  @Test
  void edgeLinkNeedsAWayRoundTheEdge() {
    assertFalse(fluid("000", "110").open(0, 0, 0, 1, 1, 0));
    assertTrue(fluid("000", "110", "100").open(0, 0, 0, 1, 1, 0));
    assertTrue(fluid("000", "110", "010").open(1, 1, 0, -1, -1, 0));
  }

  @Test
  void cornerLinkNeedsAWayOfThreeFaces() {
    assertFalse(fluid("000", "111").open(0, 0, 0, 1, 1, 1));
    assertFalse(fluid("000", "111", "100", "011").open(0, 0, 0, 1, 1, 1));
    assertTrue(fluid("000", "111", "100", "110").open(0, 0, 0, 1, 1, 1));
    assertTrue(fluid("000", "111", "100", "110").open(1, 1, 1, -1, -1, -1));
  }

  @Test
  void linksWrapOnPeriodicAxesOnly() {
    Lattice box = Lattice.empty(3, 3, 3, Ends.PERIODIC, Ends.OPEN, Ends.OPEN);
    assertTrue(box.open(0, 1, 1, -1, 0, 0));
    assertFalse(box.open(0, 0, 1, -1, -1, 0));
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
