package org.hdispatch.porous.pore;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.Phase;
import org.hdispatch.porous.image.VoxelImage;
import org.junit.jupiter.api.Test;

class PoreSpaceTest {

  @Test
  void theRuleDecidesWhatIsPore() {
    VoxelImage image = VoxelImage.of(2, 1, 2, new byte[] {0, (byte) 255, 1, 0});
    PoreSpace space = PoreSpace.of(image, LabelRule.poreIs(0, 255));
    assertTrue(space.isPore(0, 0, 0));
    assertTrue(space.isPore(1, 0, 0));
    assertFalse(space.isPore(0, 0, 1));
    assertTrue(space.isPore(3));
    assertEquals(Phase.SOLID, space.phase(0, 0, 1));
    assertEquals(3, space.poreVoxels());
    assertEquals(0.75, space.porosity());
  }

  @Test
  void aFormulaIsAskedInTheOrderOfTheAxes() {
    PoreSpace space = PoreSpace.of(2, 3, 4, (x, y, z) -> x == 1 && y == 2 && z == 3);
    assertEquals(1, space.poreVoxels());
    assertTrue(space.isPore(1, 2, 3));
    assertTrue(space.isPore(space.index(1, 2, 3)));
    assertEquals(24, space.voxels());
    assertEquals(2, space.nx());
    assertEquals(3, space.ny());
    assertEquals(4, space.nz());
  }

  @Test
  void countsPoresAndDifferencesOfAStretch() {
    PoreSpace space = PoreSpace.of(3, 2, 1, (x, y, z) -> x == 1 || y == 1 && x == 2); // 010 011
    assertEquals(1, space.poreVoxels(0, 3));
    assertEquals(2, space.poreVoxels(4, 6));
    assertEquals(0, space.poreVoxels(2, 2));
    assertEquals(2, space.differences(0, 2, 1));
    assertEquals(1, space.differences(0, 3, 3));
  }

  @Test
  void sizesThatNoArrayHoldsAreRefused() {
    assertThrows(
        IllegalArgumentException.class, () -> PoreSpace.of(2000, 2000, 2000, (x, y, z) -> true));
  }
}
