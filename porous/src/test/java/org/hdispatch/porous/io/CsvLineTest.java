package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

class CsvLineTest {
  @Test
  void valuesComeBackAsTheyWere() {
    List<String> values = List.of("", "1.5", "a, b", "say \"x\"", "\"", "two\nlines", "");
    String line = CsvLine.format(values);
    assertEquals(",1.5,\"a, b\",\"say \"\"x\"\"\",\"\"\"\",\"two\nlines\",", line);
    assertEquals(values, CsvLine.parse(line));
    assertEquals(List.of(""), CsvLine.parse(""));
  }

  @Test
  void tornQuotesAreRefused() {
    for (String line : List.of("a,\"b", "\"", "\"a\"b,c", "\"a\"\"")) {
      assertThrows(IllegalArgumentException.class, () -> CsvLine.parse(line));
    }
  }
}
