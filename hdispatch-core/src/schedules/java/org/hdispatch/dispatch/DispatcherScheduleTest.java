package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.junit.jupiter.api.Test;

/**
 * Four cells, one or two workers that park at once: a run of two steps, with a cancel, a close or a
 * failure at any moment, always ends, with every cell once or not at all in a step, and after the
 * close every thread is gone.
 */
class DispatcherScheduleTest {
  private static final CellMap<Integer> CELLS =
      CellMap.of(CellGrid.of(4, 1, 1, Ends.OPEN).keys(), KeyOrder.ROW, CellKey::i);

  /** How a run ended. */
  private enum End {
    COMPLETE,
    CANCELLED,
    FAILED,
    REFUSED
  }

  /** A dispatcher with a loop that counts the visits of its cells. */
  private static final class Bench {
    final Thread caller = Thread.currentThread();
    final Dispatcher dispatcher;
    final TimeLoop loop;
    final int[] visits = new int[CELLS.size()];
    volatile Thread worker; // worker 1
    volatile boolean cancelled; // a cancel has returned
    volatile boolean closed; // a close has returned
    boolean cancelSeen; // by the caller's thread
    boolean failing; // the last cell throws; set between runs

    Bench(int workers) {
      dispatcher = Dispatcher.builder().workers(workers).waitPolicy(WaitPolicy.PARK).build();
      loop =
          dispatcher.loop(
              Scheme.of(CELLS)
                  .scratch(this::scratch)
                  .pass("count", (cell, scratch, tick) -> visit(cell))
                  .beforeStep(tick -> cancelSeen = cancelled)
                  .build());
    }

    private Thread scratch() {
      if (Thread.currentThread() != caller) {
        worker = Thread.currentThread();
      }
      return Thread.currentThread();
    }

    /** The kernel; what it throws ends the test. */
    private void visit(int cell) {
      assertFalse(closed, "close returned before the run");
      visits[cell]++;
      if (Thread.currentThread() == caller) {
        assertFalse(cancelSeen, "caller pulled after the cancel had returned");
        cancelSeen = cancelled;
      }
      if (failing && cell == CELLS.size() - 1) {
        throw new ArithmeticException("on purpose");
      }
    }

    void forget() {
      Arrays.fill(visits, 0);
    }

    End run(int steps) {
      End end = end(steps);
      long complete = loop.tick().step();
      assertEquals(end == End.COMPLETE, complete == steps);
      for (int each : visits) {
        assertTrue(each == complete || each == complete + 1 && end != End.COMPLETE);
      }
      return end;
    }

    private End end(int steps) {
      try {
        loop.run(steps);
        return End.COMPLETE;
      } catch (CancellationException e) {
        return End.CANCELLED;
      } catch (KernelException e) {
        if (e.getCause() instanceof ArithmeticException) {
          return End.FAILED;
        }
        throw e;
      } catch (IllegalStateException e) {
        return End.REFUSED;
      }
    }

    void cancel() {
      loop.cancel();
      cancelled = true;
    }

    void close() {
      dispatcher.close();
      closed = true;
      assertFalse(worker != null && worker.isAlive(), "close returned before worker 1 had ended");
    }
  }

  @Test
  void theCloseOfAnIdleDispatcherEndsItsWorkers() {
    Schedules.explore(
        4_000, () -> Dispatcher.builder().workers(3).waitPolicy(WaitPolicy.PARK).build().close());
  }

  @Test
  void aCloseEndsTheMakingOfALoop() {
    Schedules.explore(
        1_000,
        () -> {
          Dispatcher dispatcher =
              Dispatcher.builder().workers(2).waitPolicy(WaitPolicy.PARK).build();
          Schedules.Fork closer = Schedules.fork(dispatcher::close);
          try {
            dispatcher.loop(Scheme.of(CELLS).pass("none", (cell, scratch, tick) -> {}).build());
          } catch (IllegalStateException e) {
            // closed before or meanwhile, which is a CancellationException
          }
          closer.join();
        });
  }

  @Test
  void aStepVisitsEveryCellOnceAndTheCloseEndsTheWorker() {
    Schedules.explore(
        1_000,
        () -> {
          Bench bench = new Bench(2);
          assertEquals(End.COMPLETE, bench.run(2));
          bench.close();
        });
  }

  @Test
  void aFailureEndsTheStepAndNotTheDispatcher() {
    Schedules.explore(
        1_000,
        () -> {
          Bench bench = new Bench(2);
          bench.failing = true;
          assertEquals(End.FAILED, bench.run(2));
          bench.failing = false;
          bench.forget();
          assertEquals(End.COMPLETE, bench.run(2));
          bench.close();
        });
  }

  @Test
  void aCancelEndsTheRunOfOneWorker() {
    cancel(1);
  }

  @Test
  void aCancelEndsTheRunOfTwoWorkers() {
    cancel(2);
  }

  private static void cancel(int workers) {
    Schedules.explore(
        1_000,
        () -> {
          Bench bench = new Bench(workers);
          Schedules.Fork canceller = Schedules.fork(bench::cancel);
          assertFalse(bench.run(2) == End.REFUSED);
          canceller.join();
          bench.close();
        });
  }

  @Test
  void aCloseEndsTheRunOfOneWorker() {
    close(1);
  }

  @Test
  void aCloseEndsTheRunOfTwoWorkers() {
    close(2);
  }

  private static void close(int workers) {
    Schedules.explore(
        1_000,
        () -> {
          Bench bench = new Bench(workers);
          Schedules.Fork closer = Schedules.fork(bench::close);
          bench.run(2);
          closer.join();
          assertEquals(End.REFUSED, bench.end(1));
        });
  }
}
