package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class JvmLogTest {
  /** Lines that JDK 17 and 25 wrote, the times made simple. */
  private static JvmLog log(long from, long to) {
    return JvmLog.of(
        Stream.of(
            "[100ns] Using G1",
            "[200ns] Safepoint \"ICBufferFull\", Time since last: 1 ns, Reaching safepoint: 2 ns,"
                + " At safepoint: 3 ns, Total: 5 ns",
            "[300ns] GC(0) Pause Young (Normal) (G1 Evacuation Pause) 14M->5M(256M) 1.234ms",
            "[310ns] Safepoint \"G1CollectForAllocation\", Time since last: 1 ns, Reaching safepoint:"
                + " 2 ns, Cleanup: 1 ns, At safepoint: 3 ns, Total: 5 ns",
            "[400ns] Safepoint \"ZMarkStart\", Time since last: 1 ns, Reaching safepoint: 2 ns, At"
                + " safepoint: 3 ns, Leaving safepoint: 1 ns, Total: 6 ns",
            "[450ns] Allocation Stall (main) 12.345ms",
            "[500ns] Safepoint \"Cleanup\", Time since last: 1 ns, Reaching safepoint: 2 ns, At"
                + " safepoint: 3 ns, Total: 5 ns",
            "a line of somebody else"),
        from,
        to);
  }

  @Test
  void tellsTheCollectorsSafepointsFromOthers() {
    assertEquals(new JvmLog(4, 2, 1), log(0, 1000));
  }

  @Test
  void countsWhatEndedInTheWindowOnly() {
    assertEquals(new JvmLog(1, 1, 0), log(301, 399));
    assertEquals(new JvmLog(2, 1, 1), log(311, 500));
    assertEquals(new JvmLog(0, 0, 0), log(501, 1000));
  }
}
