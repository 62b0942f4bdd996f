package org.hdispatch.app.permeability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.OptionalDouble;
import org.hdispatch.porous.flow.FlowListener.Progress;
import org.junit.jupiter.api.Test;

class ProgressLineTest {
  private static Progress at(int measurement, double error) {
    return new Progress(
        50L * measurement, 100_000, 0.024, error, 1e-3, 0, 0.5 * measurement, 0, 12.34);
  }

  @Test
  void timeLeftFollowsTheDecayOfTheError() {
    ProgressLine.TimeLeft left = new ProgressLine.TimeLeft();
    for (int n = 1; n <= 20; n++) {
      left.add(at(n, Math.pow(10, -0.1 * n))); // a tenth every 10 measurements, 5 s
    }
    assertEquals(5, left.seconds(), 1e-9); // from 1e-2 to 1e-3
  }

  @Test
  void timeLeftIsUnknownWithoutDecay() {
    ProgressLine.TimeLeft left = new ProgressLine.TimeLeft();
    left.add(at(1, Double.POSITIVE_INFINITY));
    left.add(at(2, Double.POSITIVE_INFINITY));
    left.add(at(3, 0.5));
    assertEquals(Double.POSITIVE_INFINITY, left.seconds());
  }

  @Test
  void lineIsWrittenOverAndWipedInTheEnd() {
    StringWriter err = new StringWriter();
    try (ProgressLine line = new ProgressLine(new PrintWriter(err), OptionalDouble.of(5.345e-6))) {
      line.progressed(at(1, Double.POSITIVE_INFINITY));
      line.progressed(at(2, 0.5));
    }
    String[] frames = err.toString().split("\r", -1);
    assertEquals(5, frames.length); // before the first, two lines, blanks, the end
    assertTrue(frames[1].startsWith("step 50  k 694.74 mD  error unknown  12.3 MFLUPS"), frames[1]);
    assertTrue(frames[2].contains("error 50 %"), frames[2]);
    assertTrue(frames[3].isBlank() && frames[4].isEmpty());
  }
}
