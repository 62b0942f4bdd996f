package org.hdispatch.app.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.HashSet;
import java.util.Set;
import org.hdispatch.porous.image.Axis;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PlaneTest {
  @ParameterizedTest
  @EnumSource
  void planeHoldsTheVoxelsAcrossItsNormal(Axis normal) {
    Plane plane = Plane.middle(normal, 3, 5, 7);
    Set<Integer> seen = new HashSet<>();
    for (int row = 0; row < plane.height(); row++) {
      for (int column = 0; column < plane.width(); column++) {
        int voxel = plane.voxel(column, row);
        seen.add(voxel);
        int at = normal.length(voxel % 3, voxel / 3 % 5, voxel / 15);
        assertEquals(normal.length(1, 2, 3), at);
      }
    }
    assertEquals(105 / normal.length(3, 5, 7), seen.size());
  }

  @Test
  void coloursRunFromDarkToBright() {
    assertEquals(0x440154, ColourMap.viridis(-1));
    assertEquals(0x21918c, ColourMap.viridis(0.5));
    assertEquals(0xfde725, ColourMap.viridis(2));
  }
}
