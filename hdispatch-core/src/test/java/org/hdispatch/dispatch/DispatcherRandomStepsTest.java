package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Random steps with exceptions, cancels and interrupts thrown in: no cell is lost, doubled or run
 * in the wrong step, no exception is lost, and the dispatcher goes on.
 */
class DispatcherRandomStepsTest {
  private static final long SEED = 20100823;

  private static final class Thrown extends RuntimeException {
    private static final long serialVersionUID = 1L;

    Thrown() {
      super("thrown on purpose", null, false, false);
    }
  }

  /** What is to happen in a step; written by the caller between steps. */
  private static final class Plan {
    int throwAt = -1;
    int cancelAt = -1;
    int interruptAt = -1;
    TimeLoop loop;
    Thread caller;
  }

  private static final class Cell {
    final int index;
    long doneInStep = -1;
    long visits;

    Cell(int index) {
      this.index = index;
    }
  }

  @ParameterizedTest
  @CsvSource({
    "1, PULL, SPIN_THEN_PARK",
    "2, PULL, SPIN_THEN_PARK",
    "2, STATIC, SPIN_THEN_PARK",
    "2, PULL, PARK",
    "3, PULL, PARK",
    "5, PULL, SPIN_THEN_PARK",
    "5, STATIC, PARK"
  })
  @Timeout(300)
  void everyCellExactlyOnce(int workers, Handout handout, WaitPolicy policy) {
    int rounds = 16_000; // 7 combinations: more than 10^5 steps
    Random random = new Random(SEED + workers);
    try (Dispatcher dispatcher =
        Dispatcher.builder().workers(workers).handout(handout).waitPolicy(policy).build()) {
      int[] sizes = {1, 7, 64, 257};
      Plan[] plans = new Plan[sizes.length];
      Cell[][] cells = new Cell[sizes.length][];
      for (int s = 0; s < sizes.length; s++) {
        Plan plan = new Plan();
        Cell[] mine = new Cell[sizes[s]];
        CellMap<Cell> map =
            CellMap.of(
                CellGrid.of(sizes[s], 1, 1, Ends.OPEN).keys(),
                KeyOrder.ROW,
                key -> {
                  int index = CellKey.i(key);
                  return mine[index] = new Cell(index);
                });
        plans[s] = plan;
        cells[s] = mine;
        plan.loop =
            dispatcher.loop(
                Scheme.of(map)
                    .scratch(Thread::currentThread)
                    .pass("check", (cell, owner, tick) -> visit(cell, owner, tick, plan))
                    .build());
      }
      for (int round = 0; round < rounds; round++) {
        int s = random.nextInt(sizes.length);
        round(plans[s], cells[s], random);
      }
    }
  }

  /** Cancels and interrupts that come from outside, at any moment between and within passes. */
  @ParameterizedTest
  @CsvSource({"1, PARK", "2, SPIN_THEN_PARK", "3, PARK"})
  @Timeout(120)
  void outsideCancelsLeaveEveryCellOnceOrNotAtAll(int workers, WaitPolicy policy) {
    Cell[] cells = new Cell[64];
    Plan plan = new Plan();
    try (Dispatcher dispatcher = Dispatcher.builder().workers(workers).waitPolicy(policy).build()) {
      CellMap<Cell> map =
          CellMap.of(
              CellGrid.of(cells.length, 1, 1, Ends.OPEN).keys(),
              KeyOrder.ROW,
              key -> cells[CellKey.i(key)] = new Cell(CellKey.i(key)));
      TimeLoop loop =
          dispatcher.loop(
              Scheme.of(map)
                  .scratch(Thread::currentThread)
                  .pass("check", (cell, owner, tick) -> visit(cell, owner, tick, plan))
                  .build());
      Thread caller = Thread.currentThread();
      AtomicBoolean over = new AtomicBoolean();
      Thread outside = new Thread(() -> disturb(loop, caller, over));
      outside.start();
      int ended = 0;
      for (int round = 0; round < 20_000; round++) {
        long step = loop.tick().step();
        for (Cell cell : cells) {
          cell.visits = 0;
        }
        boolean whole = true;
        try {
          loop.run(1);
        } catch (CancellationException e) {
          whole = false;
          ended++;
          Thread.interrupted();
        }
        assertEquals(whole ? step + 1 : step, loop.tick().step());
        for (Cell cell : cells) {
          assertTrue(cell.visits == 1 || !whole && cell.visits == 0, "visits=" + cell.visits);
        }
      }
      over.set(true);
      while (outside.isAlive()) { // it may still interrupt
        Thread.onSpinWait();
      }
      Thread.interrupted();
      assertTrue(ended > 0, "nothing was ever disturbed");
    }
  }

  private static void disturb(TimeLoop loop, Thread caller, AtomicBoolean over) {
    Random random = new Random(SEED);
    while (!over.get()) {
      for (int pause = random.nextInt(2_000); pause > 0; pause--) {
        Thread.onSpinWait();
      }
      if (random.nextBoolean()) {
        loop.cancel();
      } else {
        caller.interrupt();
      }
    }
  }

  private static void visit(Cell cell, Thread owner, Tick tick, Plan plan) {
    assertSame(owner, Thread.currentThread());
    cell.visits++;
    cell.doneInStep = tick.step();
    if (cell.index == plan.throwAt) {
      throw new Thrown();
    }
    if (cell.index == plan.cancelAt) {
      plan.loop.cancel();
    }
    if (cell.index == plan.interruptAt) {
      plan.caller.interrupt();
    }
  }

  private static void round(Plan plan, Cell[] cells, Random random) {
    int what = random.nextInt(8);
    int where = random.nextInt(cells.length);
    plan.caller = Thread.currentThread();
    plan.throwAt = what == 0 ? where : -1;
    plan.cancelAt = what == 1 ? where : -1;
    plan.interruptAt = what == 2 ? where : -1;
    if (what == 3) {
      LockSupport.parkNanos(1_000); // lets workers fall asleep
    }
    long step = plan.loop.tick().step();
    for (Cell cell : cells) {
      cell.visits = 0;
    }
    boolean failed = false;
    boolean ended = false;
    try {
      plan.loop.run(1);
    } catch (KernelException e) {
      failed = true;
      assertSame(Thrown.class, e.getCause().getClass());
      assertEquals(where, CellKey.i(e.cellKey()));
      assertEquals(step, e.step());
    } catch (CancellationException e) {
      ended = true;
    }
    assertEquals(what == 0, failed);
    assertEquals(what == 1 || what == 2, ended);
    assertEquals(what == 2, Thread.interrupted());
    boolean whole = !failed && !ended;
    assertEquals(whole ? step + 1 : step, plan.loop.tick().step());
    for (Cell cell : cells) {
      assertTrue(cell.visits == 1 || !whole && cell.visits == 0, "visits=" + cell.visits);
      assertTrue(cell.visits == 0 || cell.doneInStep == step, "stale cell");
    }
  }
}
