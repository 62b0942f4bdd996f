package org.hdispatch.app.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import org.hdispatch.app.draw.LogPlot.Scale;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.image.VoxelBox;
import org.junit.jupiter.api.Test;

class BlockMapTest {
  private static final Scale AXIS =
      new Scale("permeability, mD", 1, 100, value -> Numbers.plain(value, 3));

  private static BlockMap.Block block(int x0, int z0, OptionalDouble value) {
    return new BlockMap.Block(new VoxelBox(x0, 0, z0, 8, 8, 8), value);
  }

  @Test
  void blocksHaveTheColourOfTheirPlaceOnTheScale() throws Exception {
    String svg =
        BlockMap.of(
            "k",
            "none",
            List.of(block(0, 0, OptionalDouble.of(1)), block(8, 4, OptionalDouble.of(100))),
            AXIS);
    StudyPageTest.parsed(svg);
    assertTrue(svg.contains(String.format("#%06x", ColourMap.viridis(0))), svg);
    assertTrue(svg.contains(String.format("#%06x", ColourMap.viridis(1))), svg);
    assertTrue(svg.contains("z0 = 0") && svg.contains("z0 = 4"), svg);
    assertTrue(svg.contains("permeability, mD"), svg);
    assertFalse(svg.contains("none"), svg);
  }

  @Test
  void blocksWithoutAValueAreStruckOutAndSaidToBe() {
    String svg =
        BlockMap.of(
            "k",
            "none",
            List.of(block(0, 0, OptionalDouble.of(10)), block(8, 0, OptionalDouble.empty())),
            AXIS);
    assertEquals(List.of(0), BlockMap.layers(List.of(block(0, 0, OptionalDouble.empty()))));
    assertTrue(svg.contains("none"), svg);
    assertTrue(svg.contains("fill=\"" + PlotInk.PALE.light() + "\""), svg);
  }
}
