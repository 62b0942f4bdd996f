package org.hdispatch.porous.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class VoxelImageTest {

  /** 2 x 3 x 4 voxels with labels 0..23 in file order. */
  private static VoxelImage counting() {
    byte[] labels = new byte[24];
    for (int i = 0; i < labels.length; i++) {
      labels[i] = (byte) i;
    }
    return VoxelImage.of(2, 3, 4, labels);
  }

  @Test
  void xRunsFastestAndZSlowest() {
    VoxelImage image = counting();
    assertEquals(1, image.label(1, 0, 0));
    assertEquals(2, image.label(0, 1, 0));
    assertEquals(6, image.label(0, 0, 1));
    assertEquals(23, image.label(1, 2, 3));
    assertEquals(23, image.label(image.index(1, 2, 3)));
  }

  @Test
  void labelsAreUnsigned() {
    assertEquals(255, VoxelImage.of(1, 1, 1, new byte[] {-1}).label(0, 0, 0));
    assertEquals(1, VoxelImage.of(1, 1, 1, new byte[] {-1}).histogram()[255]);
  }

  @Test
  void cropKeepsEveryVoxelOfTheBoxAndTheEdge() {
    VoxelImage image = counting().withVoxelEdge(5.345e-6);
    VoxelBox box = new VoxelBox(1, 1, 2, 1, 2, 2);
    VoxelImage part = image.crop(box);
    assertEquals(5.345e-6, part.voxelEdge().getAsDouble());
    for (int z = 0; z < 2; z++) {
      for (int y = 0; y < 2; y++) {
        assertEquals(image.label(1, 1 + y, 2 + z), part.label(0, y, z));
      }
    }
  }

  @Test
  void histogramCountsEveryLabel() {
    long[] histogram = VoxelImage.of(2, 1, 2, new byte[] {0, 7, 7, 0}).histogram();
    assertEquals(256, histogram.length);
    assertEquals(2, histogram[0]);
    assertEquals(2, histogram[7]);
  }

  @Test
  void toLabelsIsACopy() {
    VoxelImage image = counting();
    image.toLabels()[0] = 99;
    assertEquals(0, image.label(0, 0, 0));
    assertArrayEquals(image.toLabels(), counting().toLabels());
  }

  @Test
  void boxOutsideIsRefusedWithBothSizes() {
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class, () -> counting().crop(new VoxelBox(1, 0, 0, 2, 1, 1)));
    assertEquals("box must lie inside the image: box=1,0,0,2,1,1, image=2x3x4", e.getMessage());
  }

  @Test
  void boxBeyondTheRangeOfIntIsOutside() {
    VoxelBox box = new VoxelBox(Integer.MAX_VALUE, 0, 0, Integer.MAX_VALUE, 1, 1);
    assertThrows(IllegalArgumentException.class, () -> box.within(10, 10, 10));
  }

  @Test
  void emptyOrNegativeBoxesAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> new VoxelBox(0, 0, 0, 0, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> new VoxelBox(0, -1, 0, 1, 1, 1));
  }

  @Test
  void moreVoxelsThanAnArrayHoldsAreRefused() {
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class, () -> VoxelImage.requireFits(1840, 1840, 1940));
    assertTrue(e.getMessage().contains("image=1840x1840x1940, voxels=6568064000"), e.getMessage());
    assertThrows(
        IllegalArgumentException.class,
        () -> VoxelImage.requireFits(Integer.MAX_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE));
  }

  @Test
  void labelsOfAnotherLengthAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> VoxelImage.of(2, 2, 2, new byte[7]));
  }

  @Test
  void voxelEdgeMustBePositiveAndFinite() {
    for (double edge : new double[] {0, -1e-6, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> counting().withVoxelEdge(edge));
    }
    assertTrue(counting().voxelEdge().isEmpty());
  }

  @Test
  void axisPicksItsLength() {
    assertEquals(2, Axis.X.length(2, 3, 4));
    assertEquals(3, Axis.Y.length(2, 3, 4));
    assertEquals(4, Axis.Z.length(2, 3, 4));
  }
}
