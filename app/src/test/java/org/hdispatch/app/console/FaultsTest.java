package org.hdispatch.app.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.channels.ClosedByInterruptException;
import java.util.concurrent.CancellationException;
import org.hdispatch.porous.io.ImageFileException;
import org.junit.jupiter.api.Test;

class FaultsTest {
  private final StringWriter err = new StringWriter();
  private final Faults faults = new Faults(new PrintWriter(err), false);

  @Test
  void heapThatRunsOutInAKernelIsTooSmall() {
    Throwable inKernel =
        new RuntimeException("pass failed", new OutOfMemoryError("Java heap space"));
    assertEquals(5, faults.report(inKernel));
    assertTrue(err.toString().contains("-Xmx"), err.toString());
    assertEquals(1, err.toString().lines().count());
  }

  @Test
  void interruptionIsOneHoweverItShows() {
    assertEquals(130, faults.report(new CancellationException("run was interrupted")));
    assertEquals(130, faults.report(new ImageFileException("x", new ClosedByInterruptException())));
    Thread.currentThread().interrupt();
    try {
      assertEquals(130, faults.report(new IllegalStateException("recorder is stopped")));
    } finally {
      Thread.interrupted();
    }
    assertEquals("hdispatch: interrupted\n".repeat(3), err.toString());
  }

  @Test
  void restIsAFaultOfOursAndSaysSo() {
    assertEquals(1, faults.report(new IllegalStateException("two\nlines")));
    assertEquals(1, err.toString().lines().count());
    assertTrue(err.toString().contains("--stacktrace"), err.toString());
  }
}
