package org.hdispatch.app.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class FlatRowTest {
  private static FlatRow row() {
    return new FlatRow()
        .put("number", 0.1 + 0.2)
        .put("whole", 3L)
        .put("truth", true)
        .put("text", "a \"b\", c\\d\n")
        .put("nan", Double.NaN)
        .put("infinite", Double.NEGATIVE_INFINITY)
        .put("unknown", OptionalDouble.empty());
  }

  @Test
  void jsonKeepsEveryDigitAndNeverPrintsNaN() {
    assertEquals(
        """
        {
          "number": 0.30000000000000004,
          "whole": 3,
          "truth": true,
          "text": "a \\"b\\", c\\\\d\\u000a",
          "nan": null,
          "infinite": null,
          "unknown": null
        }
        """,
        row().toJson());
  }

  @Test
  void csvLeavesTheUnknownEmptyAndQuotesText() {
    assertEquals(
        """
        number,whole,truth,text,nan,infinite,unknown
        0.30000000000000004,3,true,"a ""b"", c\\d
        ",,,
        """,
        row().toCsv());
  }
}
