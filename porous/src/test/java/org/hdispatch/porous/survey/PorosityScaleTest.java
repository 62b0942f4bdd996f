package org.hdispatch.porous.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.junit.jupiter.api.Test;

class PorosityScaleTest {
  /**
   * Half the cubes of 8 are pore, as on a chessboard; two layers of voxels are left over along x.
   */
  private static VoxelImage chessboard() {
    byte[] labels = new byte[34 * 32 * 32];
    for (int n = 0; n < labels.length; n++) {
      int x = n % 34;
      int y = n / 34 % 32;
      int z = n / 34 / 32;
      labels[n] = (byte) (x >= 32 || (x / 8 + y / 8 + z / 8) % 2 == 0 ? 1 : 0);
    }
    return VoxelImage.of(34, 32, 32, labels);
  }

  @Test
  void cubesOfAChessboardAreFullOrEmptyAndTwiceAsLargeOnesAllAlike() throws Exception {
    VoxelImage image = chessboard();
    List<PorosityScale> scales =
        PorosityScale.of(VoxelBox.whole(34, 32, 32), image::crop, LabelRule.poreIs(1));
    assertEquals(List.of(8, 16), scales.stream().map(PorosityScale::edge).toList());
    Spread small = scales.get(0).porosity();
    assertEquals(64, small.count());
    assertEquals(0.5, small.arithmetic());
    assertEquals(0.5 * Math.sqrt(64.0 / 63), small.deviation(), 1e-15);
    Spread large = scales.get(1).porosity();
    assertEquals(8, large.count());
    assertEquals(0.5, large.least());
    assertEquals(0, large.deviation());
  }

  @Test
  void imageOfASingleCubeSaysNothing() throws Exception {
    VoxelImage image = VoxelImage.of(8, 8, 15, new byte[8 * 8 * 15]);
    assertEquals(
        List.of(), PorosityScale.of(VoxelBox.whole(8, 8, 15), image::crop, LabelRule.poreIs(1)));
    VoxelImage tiny = VoxelImage.of(4, 8, 8, new byte[4 * 8 * 8]);
    assertEquals(
        List.of(), PorosityScale.of(VoxelBox.whole(4, 8, 8), tiny::crop, LabelRule.poreIs(1)));
  }
}
