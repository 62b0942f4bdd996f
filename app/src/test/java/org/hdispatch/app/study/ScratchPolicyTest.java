package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.gc.AllocationMeter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

@Timeout(120)
class ScratchPolicyTest {
  private static final int STEPS = 3;
  private static final int THREADS = 3;

  @ParameterizedTest
  @EnumSource(Workload.class)
  void everyPolicyGivesTheSameBits(Workload workload) {
    int scratch = StudyScope.STANDARD;
    Work<?, ?> first = Work.of(workload, scratch);
    long before = first.checksum().getAsLong();
    long expected = checksum(first, ScratchPolicy.ENDURING);
    assertNotEquals(before, expected);
    for (ScratchPolicy policy : ScratchPolicy.values()) {
      boolean possible =
          policy != ScratchPolicy.THREAD_LOCAL_VIRTUAL || Runtime.version().feature() >= 21;
      if (policy != ScratchPolicy.ENDURING && possible) {
        assertEquals(expected, checksum(Work.of(workload, scratch), policy), policy.toString());
      }
    }
  }

  private static long checksum(Work<?, ?> work, ScratchPolicy policy) {
    try (Stepper stepper = Stepper.of(work, policy, THREADS)) {
      for (int step = 0; step < STEPS; step++) {
        stepper.step();
      }
      int threads = stepper.threads().length; // a pool has the caller beside its threads
      assertTrue(
          policy == ScratchPolicy.THREAD_LOCAL_VIRTUAL
              || threads == THREADS + (policy == ScratchPolicy.THREAD_LOCAL_POOL ? 1 : 0),
          policy + ": threads=" + threads);
      return work.checksum().getAsLong();
    }
  }

  @Test
  void scratchIsAsLargeAsAsked() {
    long bytes = bytesPerCell(Work.of(Workload.LBM, StudyScope.STANDARD));
    assertEquals(StudyScope.STANDARD, bytes, 64); // headers of the record and of the array
    assertEquals(1 << 20, bytesPerCell(Work.of(Workload.COMPUTE, 1 << 20)), 16);
  }

  private static long bytesPerCell(Work<?, ?> work) {
    AllocationMeter meter = new AllocationMeter(Thread.currentThread().getId());
    long[] before = new long[1];
    long[] after = new long[1];
    try (Stepper stepper = Stepper.of(work, ScratchPolicy.PER_CELL, 1)) {
      stepper.step();
      meter.read(before);
      stepper.step();
      meter.read(after);
      return (after[0] - before[0]) / work.scheme().cells().size();
    }
  }

  @Test
  void scratchSmallerThanTheMethodNeedsIsRefused() {
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> Work.of(Workload.LBM, 4096));
    assertTrue(
        e.getMessage().startsWith("scratch must hold what the method needs: asked=4096 B"),
        e.getMessage());
  }
}
