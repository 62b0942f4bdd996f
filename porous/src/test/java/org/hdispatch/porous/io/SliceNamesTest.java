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
    "a1.tif, a2.tif, false", "a09.tif, a10.tif, false", "a1.tif, a3.tif, true",
    "a1.tif, a01.tif, true", "a1.tif, b3.tif, false", "top.tif, under.tif, false",
    "rock2_009.tif, rock2_011.tif, true"
  })
  void gapsAreSeen(String before, String after, boolean gap) {
    assertEquals(gap, SliceNames.leaveGap(before, after));
  }
}
