package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SliceNamesTest {
  @Test
  void numbersCountAsNumbers() {
    List<String> names =
        List.of(
            "a1.tif",
            "a2.tif",
            "a010.tif",
            "a10.tif",
            "a11.tif",
            "a99999999999999999999.tif",
            "b1_2.tif",
            "b1_10.tif",
            "b2_1.tif",
            "c.tif");
    List<String> shuffled = new ArrayList<>(names);
    Collections.shuffle(shuffled, new Random(1));
    shuffled.sort(SliceNames::compare);
    assertEquals(names, shuffled);
  }

  @ParameterizedTest
  @CsvSource({
    "a1.tif, a2.tif, 1",
    "a09_8bit.tif, a10_8bit.tif, 1",
    "b2_1.tif, b2_2.tif, 3",
    "2.tif, 3.tif, 0",
    "a1.tif, b2.tif, -1",
    "a1.tif, a2.tiff, -1",
    "b2_9.tif, b3_1.tif, -1",
    "\u0663.tif, \u0664.tif, -1",
    "a.tif, a1.tif, -1",
    "a.tif, b.tif, -1"
  })
  void theOnlyDifferentNumberIsFound(String a, String b, int part) {
    assertEquals(part, SliceNames.onlyDifferentNumber(a, b));
  }

  @ParameterizedTest
  @CsvSource({
    "a1.tif, a2.tif, false", "a09.tif, a10.tif, false", "a1.tif, a3.tif, true",
    "a1.tif, a01.tif, true", "a1.tif, b3.tif, false", "top.tif, under.tif, false",
    "rock2_009.tif, rock2_011.tif, true", "a1_8bit.tif, a3_8bit.tif, true"
  })
  void gapsAreSeen(String before, String after, boolean gap) {
    assertEquals(gap, SliceNames.leaveGap(before, after));
  }
}
