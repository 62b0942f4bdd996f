package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import org.hdispatch.cell.CellChanges;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(120)
class DispatcherTest {

  /** A cell that counts; two buffers of values for order-sensitive arithmetic. */
  static final class Counter {
    final long key;
    long visits;
    final double[][] value = new double[2][4];

    Counter(long key) {
      this.key = key;
      Arrays.setAll(value[0], i -> 1.0 / (1 + i + CellKey.i(key) + 3 * CellKey.j(key)));
    }
  }

  static CellMap<Counter> counters(int n) {
    return CellMap.of(CellGrid.of(n, 1, 1, Ends.OPEN).keys(), KeyOrder.ROW, Counter::new);
  }

  private static Scheme<Counter, Void> counting(CellMap<Counter> cells) {
    return Scheme.of(cells).pass("count", (cell, scratch, tick) -> cell.visits++).build();
  }

  @ParameterizedTest
  @EnumSource(WaitPolicy.class)
  void processesEveryCellOnceAStepUnderEveryWaitPolicy(WaitPolicy policy) {
    CellMap<Counter> cells = counters(37);
    try (Dispatcher dispatcher = Dispatcher.builder().workers(2).waitPolicy(policy).build()) {
      TimeLoop loop = dispatcher.loop(counting(cells));
      loop.run(2_000);
      assertEquals(2_000, loop.tick().step());
      assertEquals(2_000, loop.stats().steps());
      assertEquals(37 * 2_000, loop.stats().workers().stream().mapToLong(w -> w.cells()).sum());
    }
    for (int n = 0; n < cells.size(); n++) {
      assertEquals(2_000, cells.cellAt(n).visits);
    }
  }

  @Test
  void runsWithoutCells() {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(counting(counters(1)));
      loop.run(3);
      TimeLoop empty = dispatcher.loop(counting(CellMap.of(new long[0], KeyOrder.ROW, k -> null)));
      empty.run(5);
      assertEquals(5, empty.tick().step());
    }
  }

  @ParameterizedTest
  @EnumSource(Handout.class)
  void sameBitsForAnyWorkerCount(Handout handout) {
    double[] reference = smooth(1, Handout.PULL, ScratchLifetime.ENDURING);
    for (int workers : new int[] {1, 2, 3, 5}) {
      assertArrayEquals(reference, smooth(workers, handout, ScratchLifetime.ENDURING));
    }
  }

  @ParameterizedTest
  @EnumSource(ScratchLifetime.class)
  void sameBitsForAnyScratchLifetime(ScratchLifetime lifetime) {
    assertArrayEquals(
        smooth(1, Handout.PULL, ScratchLifetime.ENDURING), smooth(2, Handout.PULL, lifetime));
  }

  /** Two passes: neighbours averaged in an order-sensitive way, then a sum in key order. */
  private static double[] smooth(int workers, Handout handout, ScratchLifetime lifetime) {
    CellGrid grid = CellGrid.of(5, 7, 3, Ends.PERIODIC);
    CellMap<Counter> cells = CellMap.of(grid.keys(), KeyOrder.MORTON, Counter::new);
    double[] sum = new double[1];
    Scheme<Counter, double[]> scheme =
        Scheme.of(cells)
            .scratch(() -> new double[4])
            .pass(
                "average",
                (cell, scratch, tick) -> {
                  Arrays.fill(scratch, 0.1);
                  for (int d = -1; d <= 1; d++) {
                    Counter near = cells.get(grid.neighbour(cell.key, d, -d, d));
                    for (int i = 0; i < 4; i++) {
                      scratch[i] = scratch[i] * 0.7 + near.value[tick.previous()][i] / (3 + d);
                    }
                  }
                  System.arraycopy(scratch, 0, cell.value[tick.current()], 0, 4);
                })
            .pass("damp", (cell, scratch, tick) -> cell.value[tick.current()][0] *= 0.9999)
            .afterStep(
                tick -> {
                  for (int n = 0; n < cells.size(); n++) {
                    sum[0] = sum[0] * 0.999 + cells.cellAt(n).value[tick.current()][0];
                  }
                })
            .build();
    try (Dispatcher dispatcher = Dispatcher.builder().workers(workers).handout(handout).build()) {
      TimeLoop loop = dispatcher.loop(scheme, lifetime);
      loop.run(300);
      double[] all = new double[4 * cells.size() + 1];
      for (int n = 0; n < cells.size(); n++) {
        System.arraycopy(cells.cellAt(n).value[loop.tick().previous()], 0, all, 4 * n, 4);
      }
      all[all.length - 1] = sum[0];
      return all;
    }
  }

  @Test
  void makesScratchOncePerWorkerOnItsOwnThread() {
    Set<Thread> makers = ConcurrentHashMap.newKeySet();
    CellMap<Counter> cells = counters(100);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(3)) {
      Scheme<Counter, Thread> scheme =
          Scheme.of(cells)
              .scratch(
                  () -> {
                    assertTrue(makers.add(Thread.currentThread()));
                    return Thread.currentThread();
                  })
              .pass("own", (cell, owner, tick) -> assertSame(owner, Thread.currentThread()))
              .build();
      dispatcher.loop(scheme).run(50);
      assertEquals(3, makers.size());
      assertTrue(makers.contains(Thread.currentThread()));
    }
  }

  @Test
  void makesScratchAnewPerCellOnRequest() {
    CellMap<Counter> cells = counters(10);
    AtomicReference<Object> last = new AtomicReference<>();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      Scheme<Counter, Object> scheme =
          Scheme.of(cells)
              .scratch(Object::new)
              .pass(
                  "fresh", (cell, scratch, tick) -> assertNotSame(last.getAndSet(scratch), scratch))
              .build();
      dispatcher.loop(scheme, ScratchLifetime.PER_CELL).run(5);
    }
  }

  @Test
  void makesScratchAnewPerStepOnRequest() {
    Object[] last = new Object[1];
    long[] lastStep = {-1};
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      CellKernel<Counter, Object> kernel =
          (cell, scratch, tick) -> {
            if (tick.step() == lastStep[0]) {
              assertSame(last[0], scratch);
            } else {
              assertNotSame(last[0], scratch);
            }
            last[0] = scratch;
            lastStep[0] = tick.step();
          };
      Scheme<Counter, Object> scheme =
          Scheme.of(counters(10))
              .scratch(Object::new)
              .pass("first", kernel)
              .pass("second", kernel)
              .build();
      dispatcher.loop(scheme, ScratchLifetime.PER_STEP).run(5);
    }
  }

  @Test
  void statisticsCountARunWhenItHasEnded() {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(counting(counters(8)));
      loop.run(3);
      loop.runUntil(
          tick -> {
            assertEquals(3, loop.stats().steps());
            assertTrue(loop.stats().nanos() > 0);
            return false;
          },
          4);
      assertEquals(7, loop.stats().steps());
      assertEquals(7 * 8, loop.stats().workers().stream().mapToLong(w -> w.cells()).sum());
      loop.resetStats();
      assertEquals(0, loop.stats().steps());
      assertEquals(0, loop.stats().nanos());
    }
  }

  @Test
  void refusesNegativeStepsAndStaysUsable() {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = dispatcher.loop(counting(counters(1)));
      assertThrows(IllegalArgumentException.class, () -> loop.run(-1));
      assertThrows(IllegalArgumentException.class, () -> loop.runUntil(tick -> false, -1));
      assertThrows(NullPointerException.class, () -> loop.runUntil(null, 1));
      loop.run(1);
      assertEquals(1, loop.tick().step());
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void allocatesNothingAfterWarmUp(int workers) {
    CellMap<Counter> cells = counters(64);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      TimeLoop loop = dispatcher.loop(counting(cells));
      assertTrue(loop.warmUp(20_000, 20), () -> loop.stats().toString());
      loop.stats().workers().forEach(worker -> assertEquals(0, worker.allocatedBytes()));
      assertEquals(20_000, loop.stats().steps());
    }
  }

  @Test
  void seesWhatIsAllocatedPerStep() {
    CellMap<Counter> cells = counters(10);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      Scheme<Counter, byte[]> scheme =
          Scheme.of(cells)
              .scratch(() -> new byte[1 << 16])
              .pass("touch", (cell, scratch, tick) -> scratch[(int) cell.key & 0xff] = 1)
              .build();
      TimeLoop loop = dispatcher.loop(scheme, ScratchLifetime.PER_CELL);
      assertFalse(loop.warmUp(100, 3));
      assertEquals(300, loop.tick().step());
      assertEquals(100, loop.stats().steps());
      long bytes = loop.stats().bytesPerStep();
      assertTrue(bytes >= 10 << 16 && bytes < 11 << 16, "bytes=" + bytes);
    }
  }

  @Test
  void reportsPassCellStepAndWorkerOfAFailureAndStaysUsable() {
    CellMap<Counter> cells = counters(100);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      Scheme<Counter, Void> scheme =
          Scheme.of(cells)
              .pass("count", (cell, scratch, tick) -> cell.visits++)
              .pass(
                  "fail",
                  (cell, scratch, tick) -> {
                    if (tick.step() == 3 && CellKey.i(cell.key) == 42) {
                      throw new ArithmeticException("density must be positive: rho=-0.2");
                    }
                  })
              .build();
      TimeLoop loop = dispatcher.loop(scheme);
      KernelException e = assertThrows(KernelException.class, () -> loop.run(10));
      assertEquals("fail", e.pass());
      assertEquals(CellKey.of(42, 0, 0), e.cellKey());
      assertEquals(3, e.step());
      assertTrue(e.worker() == 0 || e.worker() == 1);
      assertEquals(ArithmeticException.class, e.getCause().getClass());
      assertEquals(
          "pass 'fail' failed at cell (42, 0, 0), step 3, worker "
              + e.worker()
              + " <- density must be positive: rho=-0.2",
          e.getMessage());
      assertEquals(3, loop.tick().step());
      TimeLoop other = dispatcher.loop(counting(cells));
      other.run(10);
      assertEquals(10, other.tick().step());
    }
  }

  @Test
  void reportsAnErrorThrownWhileScratchIsMade() {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      Scheme<Counter, Object> scheme =
          Scheme.of(counters(1))
              .<Object>scratch(
                  () -> {
                    throw new OutOfMemoryError("no room");
                  })
              .pass("none", (cell, scratch, tick) -> {})
              .build();
      KernelException e = assertThrows(KernelException.class, () -> dispatcher.loop(scheme));
      assertEquals(OutOfMemoryError.class, e.getCause().getClass());
      dispatcher.loop(counting(counters(5))).run(5);
    }
  }

  /** What cannot even be described must end the step all the same, on whichever worker. */
  @ParameterizedTest
  @EnumSource(Handout.class)
  void failureThatCannotBeDescribedEndsTheStep(Handout handout) {
    CellMap<Counter> cells = counters(100);
    try (Dispatcher dispatcher = Dispatcher.builder().workers(2).handout(handout).build()) {
      TimeLoop loop =
          dispatcher.loop(
              Scheme.of(cells)
                  .pass(
                      "fail",
                      (cell, scratch, tick) -> {
                        if (CellKey.i(cell.key) == 99) { // in the home segment of worker 1
                          throw new IllegalStateException() {
                            private static final long serialVersionUID = 1L;

                            @Override
                            public String getMessage() {
                              throw new ArithmeticException("no message");
                            }
                          };
                        }
                      })
                  .build());
      for (int round = 0; round < 50; round++) {
        assertThrows(ArithmeticException.class, () -> loop.run(1));
      }
      dispatcher.loop(counting(cells)).run(5);
    }
  }

  @Test
  void cancelFromAnotherThreadEndsTheStepEarly() throws InterruptedException {
    CellMap<Counter> cells = counters(1_000);
    CountDownLatch started = new CountDownLatch(1);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(slow(cells, started));
      Thread other =
          new Thread(
              () -> {
                assertDoesNotThrow(() -> started.await());
                loop.cancel();
              });
      other.start();
      assertThrows(CancellationException.class, () -> loop.run(1));
      other.join();
      assertTrue(visits(cells) < 1_000, "cells taken back");
      assertEquals(0, loop.tick().step());
      loop.resetStats();
      dispatcher.loop(counting(cells)).run(1);
    }
  }

  @Test
  void interruptionEndsTheStepEarlyAndStaysSet() {
    CellMap<Counter> cells = counters(1_000);
    CountDownLatch started = new CountDownLatch(1);
    Thread caller = Thread.currentThread();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(slow(cells, started));
      new Thread(
              () -> {
                assertDoesNotThrow(() -> started.await());
                caller.interrupt();
              })
          .start();
      assertThrows(CancellationException.class, () -> loop.run(1));
      assertTrue(Thread.interrupted());
      assertTrue(visits(cells) < 1_000);
      dispatcher.loop(counting(cells)).run(1);
    }
  }

  private static Scheme<Counter, Void> slow(CellMap<Counter> cells, CountDownLatch started) {
    return Scheme.of(cells)
        .pass(
            "slow",
            (cell, scratch, tick) -> {
              started.countDown();
              LockSupport.parkNanos(2_000_000);
              cell.visits++;
            })
        .build();
  }

  private static long visits(CellMap<Counter> cells) {
    long visits = 0;
    for (int n = 0; n < cells.size(); n++) {
      visits += cells.cellAt(n).visits;
    }
    return visits;
  }

  @Test
  void closeEndsARunOnAnotherThreadAndJoinsEveryThread() throws InterruptedException {
    CellMap<Counter> cells = counters(1_000);
    CountDownLatch started = new CountDownLatch(1);
    Dispatcher dispatcher = Dispatcher.builder().workers(3).name("closing").build();
    TimeLoop loop = dispatcher.loop(slow(cells, started));
    AtomicReference<Throwable> thrown = new AtomicReference<>();
    Thread runner =
        new Thread(
            () -> {
              try {
                loop.run(1_000);
              } catch (CancellationException e) {
                thrown.set(e);
              }
            });
    runner.start();
    started.await();
    dispatcher.close();
    runner.join();
    assertEquals(CancellationException.class, thrown.get().getClass());
    assertTrue(
        Thread.getAllStackTraces().keySet().stream()
            .noneMatch(thread -> thread.getName().startsWith("closing")));
    assertThrows(IllegalStateException.class, () -> loop.run(1));
    assertThrows(IllegalStateException.class, () -> dispatcher.loop(counting(cells)));
    dispatcher.close();
  }

  @Test
  void startsDaemonThreadsAndWorksOnTheCallersToo() {
    Set<Thread> seen = ConcurrentHashMap.newKeySet();
    try (Dispatcher dispatcher = Dispatcher.builder().workers(3).name("daemon").build()) {
      dispatcher.loop(
          Scheme.of(counters(3))
              .scratch(() -> seen.add(Thread.currentThread()))
              .pass("none", (cell, scratch, tick) -> {})
              .build());
      assertEquals(3, seen.size());
      assertTrue(seen.remove(Thread.currentThread()));
      for (Thread thread : seen) {
        assertTrue(thread.isDaemon());
        assertTrue(thread.getName().startsWith("daemon-worker-"), thread.getName());
      }
    }
  }

  @Test
  void loopsTakeTurnsFromAnyThread() throws InterruptedException {
    CellMap<Counter> cells = counters(20);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop one = dispatcher.loop(counting(cells));
      TimeLoop other = dispatcher.loop(counting(cells));
      for (int turn = 0; turn < 20; turn++) {
        one.run(5);
        Thread thread = new Thread(() -> turnOf(one, other).run(5));
        thread.start();
        thread.join();
        other.run(5);
      }
      assertEquals(20 * 20 * 15, visits(cells));
    }
  }

  private static TimeLoop turnOf(TimeLoop one, TimeLoop other) {
    return one.tick().step() < other.tick().step() ? one : other;
  }

  @ParameterizedTest
  @EnumSource(Handout.class)
  void everyPassSeesWhatTheLastOneWrote(Handout handout) {
    CellMap<Counter> cells = counters(64);
    Scheme<Counter, Void> scheme =
        Scheme.of(cells)
            .pass("write", (cell, scratch, tick) -> cell.visits = tick.step())
            .pass(
                "read",
                (cell, scratch, tick) -> {
                  for (int n = 0; n < 64; n++) {
                    assertEquals(tick.step(), cells.cellAt(n).visits);
                  }
                })
            .build();
    try (Dispatcher dispatcher = Dispatcher.builder().workers(3).handout(handout).build()) {
      dispatcher.loop(scheme).run(3_000);
    }
  }

  @Test
  void twoDispatchersRunSideBySide() throws InterruptedException {
    List<CellMap<Counter>> maps = List.of(counters(50), counters(50));
    Thread[] threads = new Thread[2];
    for (int t = 0; t < 2; t++) {
      CellMap<Counter> cells = maps.get(t);
      threads[t] =
          new Thread(
              () -> {
                try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
                  dispatcher.loop(counting(cells)).run(5_000);
                }
              });
      threads[t].start();
    }
    for (Thread thread : threads) {
      thread.join();
    }
    maps.forEach(cells -> assertEquals(50 * 5_000, visits(cells)));
  }

  @Test
  void refusesALoopInsideAKernel() {
    CellMap<Counter> cells = counters(4);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop inner = dispatcher.loop(counting(cells));
      TimeLoop outer =
          dispatcher.loop(
              Scheme.of(cells).pass("nest", (cell, scratch, tick) -> inner.run(1)).build());
      KernelException e = assertThrows(KernelException.class, () -> outer.run(1));
      assertEquals(IllegalStateException.class, e.getCause().getClass());
    }
  }

  @Test
  void refusesCellsThatChangeDuringAStep() {
    CellMap<Counter> cells = counters(4);
    CellChanges changes = new CellChanges();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop =
          dispatcher.loop(
              Scheme.of(cells)
                  .pass(
                      "meddle",
                      (cell, scratch, tick) -> {
                        if (CellKey.i(cell.key) == 3) {
                          changes.add(CellKey.of(9, 0, 0));
                          cells.apply(changes);
                        }
                      })
                  .build());
      assertThrows(IllegalStateException.class, () -> loop.run(1));
      assertEquals(0, loop.tick().step());
    }
  }

  @Test
  void stopsWhenTheConditionHolds() {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(counting(counters(8)));
      assertTrue(loop.runUntil(tick -> tick.step() == 7, 100));
      assertEquals(7, loop.tick().step());
      assertFalse(loop.runUntil(tick -> false, 5));
      assertEquals(12, loop.tick().step());
    }
  }

  @Test
  void staticHandoutNeverSteals() {
    try (Dispatcher dispatcher = Dispatcher.builder().workers(2).handout(Handout.STATIC).build()) {
      TimeLoop loop = dispatcher.loop(counting(counters(100)));
      loop.run(1_000);
      loop.stats()
          .workers()
          .forEach(
              worker -> {
                assertEquals(0, worker.stolen());
                assertEquals(50_000, worker.cells());
              });
    }
  }

  @Test
  void refusesNoWorkers() {
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> Dispatcher.withWorkers(0));
    assertEquals("workers must number at least 1: workers=0", e.getMessage());
  }
}
