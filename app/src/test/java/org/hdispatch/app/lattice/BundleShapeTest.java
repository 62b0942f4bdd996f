package org.hdispatch.app.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.hdispatch.lbm.BundleSize;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BundleShapeTest {
  @Test
  void oneNumberIsACube() {
    assertEquals(BundleSize.cube(20), BundleShape.parse("20").in(200));
    assertEquals(new BundleSize(64, 16, 8), BundleShape.parse("64,16,8").in(200));
  }

  @Test
  void shapeIsCutToTheDuct() {
    assertEquals(new BundleSize(200, 20, 20), BundleShape.parse("all,20,20").in(200));
    assertEquals(new BundleSize(12, 12, 5), BundleShape.parse("20,all,5").in(12));
  }

  @Test
  void shapeThatBecomesTooLargeIsRefused() {
    assertEquals(new BundleSize(300, 300, 300), BundleShape.parse("all").in(300));
    assertThrows(IllegalArgumentException.class, () -> BundleShape.parse("all").in(400));
  }

  @ParameterizedTest
  @ValueSource(strings = {"20", "64,16,16", "all,8,8", "all", "1,all,3"})
  void isWrittenAsItIsRead(String text) {
    assertEquals(text, BundleShape.parse(text).toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "0", "-3", "x", "20,20", "1,2,3,4", "1,,3", "2.5", "All", "20x20x20"})
  void anythingElseIsRefused(String text) {
    assertThrows(IllegalArgumentException.class, () -> BundleShape.parse(text));
  }
}
