package org.hdispatch.app.study;

import java.io.IOException;

/** Finds the smallest heap by bisection. */
final class HeapSearch {
  private static final long MIB = 1 << 20;
  private static final long LEAST = 2; // MiB; no workload runs in it
  private static final long FIRST = 160; // MiB; each should
  private static final long MOST = 16_384; // MiB
  private static final double SECONDS = 0.2; // some hundred collections, where it is tight
  private static final double PATIENCE = 15; // s

  private final Forks forks;
  private final Jdk jdk;
  private final double close;
  private final String build;

  /**
   * Says how to look.
   *
   * @param jdk whose JVM runs
   * @param close how many times the largest heap found too small the result may be; above 1
   * @param build hash of the code that runs
   */
  HeapSearch(Forks forks, Jdk jdk, double close, String build) {
    this.forks = forks;
    this.jdk = jdk;
    this.close = close;
    this.build = build;
  }

  /**
   * Looks for it.
   *
   * @throws IOException if no heap is large enough, with the reason, or a JVM cannot be started
   */
  SmallestHeap find(Workload workload, int scratchBytes) throws IOException {
    GcCase what =
        new GcCase(
            jdk.version(), Collector.SERIAL, ScratchPolicy.PER_CELL, workload, scratchBytes, 1);
    long tooSmall = LEAST;
    long enough = FIRST;
    Forks.Outcome ended = run(what, enough);
    while (ended.figures().isEmpty()) {
      tooSmall = enough;
      enough *= 2;
      if (enough > MOST) {
        throw new IOException("workload must run in some heap: case=" + what + ", " + ended.why());
      }
      ended = run(what, enough);
    }
    while (enough - tooSmall > 1 && enough > close * tooSmall) {
      long middle = (enough + tooSmall) / 2;
      if (run(what, middle).figures().isPresent()) {
        enough = middle;
      } else {
        tooSmall = middle;
      }
    }
    return new SmallestHeap(workload, scratchBytes, jdk.version(), enough * MIB, build);
  }

  private Forks.Outcome run(GcCase what, long mebibytes) throws IOException {
    return forks.run(what, jdk, mebibytes * MIB, 0, SECONDS, PATIENCE);
  }
}
