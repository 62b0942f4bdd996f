package org.hdispatch.bench.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.KernelForm;
import org.junit.jupiter.api.Test;

class ParametersTest {
  @Test
  void readsSizesOfBundles() {
    assertEquals(BundleSize.cube(20), BundleSizes.parse("20"));
    assertEquals(new BundleSize(200, 100, 10), BundleSizes.parse("200x100x10"));
    assertThrows(IllegalArgumentException.class, () -> BundleSizes.parse("20x10"));
    assertThrows(IllegalArgumentException.class, () -> BundleSizes.parse("large"));
  }

  @Test
  void readsFormsOfTheKernel() {
    assertEquals(KernelForm.REFERENCE, Kernels.parse("REFERENCE"));
    assertEquals(KernelForm.fastest(), Kernels.parse(Kernels.FASTEST));
    assertThrows(IllegalArgumentException.class, () -> Kernels.parse("SLOW"));
  }
}
