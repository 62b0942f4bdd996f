package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;

class RecordJsonTest {
  private static final GcCase RUN = GcRows.run(Collector.ZGC, ScratchPolicy.OBJECT_POOL, 1.3);

  @Test
  void rowComesBackAsItWas() throws IOException {
    GcRow row = GcRows.row(RUN, 1.0 / 3, 1e-9);
    assertEquals(row, RecordJson.read(GcRow.class, RecordJson.write(row)));
  }

  @Test
  void rowOfAJvmThatDiedComesBackAsItWas() throws IOException {
    GcRow row = GcRows.died(RUN, "said \"no\" \u00b5");
    assertEquals(row, RecordJson.read(GcRow.class, RecordJson.write(row)));
  }

  @Test
  void refusesWhatIsNotOfTheRecord() throws IOException {
    String text = RecordJson.write(RUN);
    assertRefused(text.replace("ZGC", "Azul"), "Collector must be known: name=Azul");
    assertRefused(text.replace("scratchBytes", "bytes"), "name=scratchBytes");
    assertRefused(text.substring(0, text.length() / 2), "GcCase");
  }

  private static void assertRefused(String text, String part) {
    IOException e = assertThrows(IOException.class, () -> RecordJson.read(GcCase.class, text));
    assertTrue(e.getMessage().contains(part), e.getMessage());
  }
}
