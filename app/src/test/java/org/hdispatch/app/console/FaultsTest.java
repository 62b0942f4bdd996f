package org.hdispatch.app.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.channels.ClosedByInterruptException;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.KernelException;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.cases.Poiseuille;
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

  /** Which flow it is of does not matter: here particles are pushed too hard. */
  @Test
  void flowThatBlowsUpNamesStepCellAndParticle() {
    SphScheme scheme = new Poiseuille(6, 0).scheme();
    scheme.drive(1e9, 0, 0);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = dispatcher.loop(scheme);
      assertEquals(
          4, faults.report(assertThrows(KernelException.class, () -> loop.run(1))), err::toString);
    }
    String line = err.toString();
    assertEquals(1, line.lines().count(), line);
    for (String word : List.of("step 0", "cell (", "particle=", "farther than a cell")) {
      assertTrue(line.contains(word), line);
    }
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
