package org.hdispatch.bench.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.LbmScheme;
import org.junit.jupiter.api.Test;

class HeldTest {
  /** A scheme counts its large arrays; headers and the map of bundles are what it leaves out. */
  @Test
  void measuresWhatASchemeSaysThatItHolds() {
    Held<LbmScheme> held =
        Held.measure(() -> LbmScheme.on(Ducts.square(60)).bundleSize(BundleSize.cube(20)).build());
    assertEquals(1, (double) held.bytes() / held.made().bytes(), 0.03);
  }
}
