package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.junit.jupiter.api.Test;

class SurroundingsTest {
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

  private static boolean open(Lattice box, int x, int y, int z, int dx, int dy, int dz) {
    BundleSize size = BundleSize.cube(3);
    CellMap<NodalBundle> bundles =
        BundleMap.of(
            box, VelocitySet.D3Q15, size, Storage.DOUBLE, Streaming.IN_PLACE, SetUp.alone());
    Surroundings surroundings = new Surroundings(box, size, bundles);
    surroundings.look(bundles.cellAt(0));
    return surroundings.open(surroundings.place(x, y, z), dx, dy, dz);
  }

  @Test
  void faceLinkIsOpenBetweenFluidNodes() {
    assertTrue(open(fluid("000", "100"), 0, 0, 0, 1, 0, 0));
    assertFalse(open(fluid("000"), 0, 0, 0, 1, 0, 0));
    assertFalse(open(fluid("000"), 0, 0, 0, -1, 0, 0));
  }

  @Test
  void edgeLinkNeedsAWayRoundTheEdge() {
    assertFalse(open(fluid("000", "110"), 0, 0, 0, 1, 1, 0));
    assertTrue(open(fluid("000", "110", "100"), 0, 0, 0, 1, 1, 0));
    assertTrue(open(fluid("000", "110", "010"), 1, 1, 0, -1, -1, 0));
  }

  @Test
  void cornerLinkNeedsAWayOfThreeFaces() {
    assertFalse(open(fluid("000", "111"), 0, 0, 0, 1, 1, 1));
    assertFalse(open(fluid("000", "111", "100", "011"), 0, 0, 0, 1, 1, 1));
    assertTrue(open(fluid("000", "111", "100", "110"), 0, 0, 0, 1, 1, 1));
    assertTrue(open(fluid("000", "111", "100", "110"), 1, 1, 1, -1, -1, -1));
  }

  @Test
  void linksWrapOnPeriodicAxesOnly() {
    Lattice box = Lattice.empty(3, 3, 3, Ends.PERIODIC, Ends.OPEN, Ends.OPEN);
    assertTrue(open(box, 0, 1, 1, -1, 0, 0));
    assertFalse(open(box, 0, 0, 1, -1, -1, 0));
  }
}
