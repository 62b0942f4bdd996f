package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.hdispatch.cell.Ends;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BundleSizeTest {
  private static Lattice box(int nx, int ny, int nz) {
    return Lattice.empty(nx, ny, nz, Ends.OPEN, Ends.OPEN, Ends.OPEN);
  }

  /** 63504, 72, 32, 50 and 16 bundles. */
  @ParameterizedTest
  @CsvSource({"1000, 64, 16", "96, 64, 16", "64, 32, 16", "40, 32, 8", "32, 32, 8"})
  void smallLatticesGetSmallerBundles(int side, int nx, int nyz) {
    assertEquals(new BundleSize(nx, nyz, nyz), BundleSize.fitting(box(side, side, side)));
  }

  @Test
  void isNoLargerThanTheLattice() {
    assertEquals(new BundleSize(3, 16, 2), BundleSize.DEFAULT.within(box(3, 100, 2)));
  }

  @Test
  void refusesBundlesWithoutNodesOrWithTooMany() {
    assertThrows(IllegalArgumentException.class, () -> new BundleSize(0, 4, 4));
    assertThrows(IllegalArgumentException.class, () -> new BundleSize(4, 0, 4));
    assertThrows(IllegalArgumentException.class, () -> new BundleSize(4, 4, -1));
    assertThrows(IllegalArgumentException.class, () -> new BundleSize(1 << 25, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> BundleSize.cube(1 << 20)); // 2^60 nodes
    assertEquals((1 << 25) - 1, new BundleSize((1 << 25) - 1, 1, 1).nodes());
  }
}
