package org.hdispatch.lbm.duct;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DuctTest {
  private static Duct duct(int side, Streaming streaming, Storage storage, BundleSize bundle) {
    return new Duct(side, VelocitySet.D3Q15, bundle, streaming, storage, KernelForm.SCALAR);
  }

  private static Duct duct(int side) {
    return duct(side, Streaming.IN_PLACE, Storage.DOUBLE, BundleSize.DEFAULT);
  }

  @Test
  void flowIsWithinWhatIsLeftOfTheStartUp() {
    Duct duct = duct(12);
    LbmScheme scheme = duct.scheme();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      var loop = dispatcher.loop(scheme);
      loop.run(duct.stepsUntil(1e-9));
      double steady = duct.kOverW2(scheme);
      // O(1/W²) of half-way bounce-back, 1 % at W = 12
      assertEquals(Duct.K_OVER_W2, steady, 0.012 * Duct.K_OVER_W2);
      scheme.initialise((x, y, z, state) -> {});
      long steps = duct.stepsUntil(0.1);
      loop.run(steps);
      double missing = 1 - duct.kOverW2(scheme) / steady;
      // the slowest mode has 0.947 of the flow, and half-way walls make it decay a little slower
      assertEquals(0.947 * duct.startUpLeft(steps), missing, 0.003);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "20,20,20",
    "10,10,10",
    "7,5,3",
    "32,8,8",
    "40,8,8",
    "40,40,10",
    "40,40,40",
    "40,1,1",
    "3,3,3"
  })
  void estimateOfBytesIsFromAbove(int nx, int ny, int nz) {
    for (Streaming streaming : Streaming.values()) {
      for (Storage storage : Storage.values()) {
        Duct duct = duct(40, streaming, storage, new BundleSize(nx, ny, nz));
        long held = duct.scheme().bytes();
        assertTrue(duct.estimatedBytes() > held, duct.estimatedBytes() + " " + held);
      }
    }
  }

  @Test
  void movesEachPopulationInAndOutOnceOrThriceWithTwoCopies() {
    assertEquals(240, duct(8).bytesMovedPerNode());
    assertEquals(
        120, duct(8, Streaming.IN_PLACE, Storage.SINGLE, BundleSize.DEFAULT).bytesMovedPerNode());
    assertEquals(
        360, duct(8, Streaming.PULL, Storage.DOUBLE, BundleSize.DEFAULT).bytesMovedPerNode());
  }

  @Test
  void refusesSidesOutOfBounds() {
    assertThrows(IllegalArgumentException.class, () -> duct(0));
    assertThrows(IllegalArgumentException.class, () -> duct(Duct.MOST + 1));
  }
}
