package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.locks.LockSupport;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.KeyOrder;

/**
 * A row of cells that is stepped at random: exceptions, cancels, interrupts, pauses, cells that
 * come and go. After every step it is checked that no cell was lost, doubled or run in the wrong
 * step, that the right exception came, and that the cells are the right ones.
 */
final class RandomRow {
  private static final class Thrown extends RuntimeException {
    private static final long serialVersionUID = 1L;

    Thrown() {
      super("thrown on purpose", null, false, false);
    }
  }

  private static final class Cell {
    final int index;
    long doneInStep = -1;
    long visits;

    Cell(int index) {
      this.index = index;
    }
  }

  private enum What {
    THROW,
    CANCEL,
    INTERRUPT,
    PAUSE,
    CHANGE_CELLS,
    NOTHING
  }

  private final Cell[] all; // those without a place in the map too
  private final boolean[] present;
  private final CellMap<Cell> map;
  private final TimeLoop loop;

  // What is to happen in a step and at which cell; written by the caller between steps.
  private What what = What.NOTHING;
  private int where;
  private int toggled;
  private Thread caller;

  RandomRow(Dispatcher dispatcher, int size) {
    all = new Cell[size];
    Arrays.setAll(all, Cell::new);
    present = new boolean[size];
    Arrays.fill(present, true);
    long[] keys = new long[size];
    Arrays.setAll(keys, RandomRow::key);
    map = CellMap.of(keys, KeyOrder.ROW, key -> all[CellKey.i(key)]);
    loop =
        dispatcher.loop(
            Scheme.of(map).scratch(Thread::currentThread).pass("check", this::visit).build());
  }

  private static long key(int index) {
    return CellKey.of(index, 0, 0);
  }

  TimeLoop loop() {
    return loop;
  }

  private void visit(Cell cell, Thread owner, Tick tick) {
    assertSame(owner, Thread.currentThread());
    cell.visits++;
    cell.doneInStep = tick.step();
    if (cell.index == where) {
      switch (what) {
        case THROW -> throw new Thrown();
        case CANCEL -> loop.cancel();
        case INTERRUPT -> caller.interrupt();
        case CHANGE_CELLS -> {
          if (present[toggled]) {
            tick.changes().remove(key(toggled));
          } else {
            tick.changes().add(key(toggled));
          }
        }
        default -> {}
      }
    }
  }

  /** One step, in which something may happen. */
  void step(Random random) {
    What[] kinds = What.values();
    what = kinds[Math.min(random.nextInt(kinds.length + 2), kinds.length - 1)];
    where = CellKey.i(map.keyAt(random.nextInt(map.size())));
    toggled = random.nextInt(all.length);
    caller = Thread.currentThread();
    if (what == What.PAUSE) {
      LockSupport.parkNanos(1_000); // lets workers fall asleep
    }
    if (what == What.CHANGE_CELLS && map.size() == 1) {
      what = What.NOTHING; // the last one stays
    }
    boolean failed = false;
    boolean ended = false;
    long step = begin();
    try {
      loop.run(1);
    } catch (KernelException e) {
      failed = true;
      assertSame(Thrown.class, e.getCause().getClass());
      assertEquals(key(where), e.cellKey());
      assertEquals(step, e.step());
    } catch (CancellationException e) {
      ended = true;
    }
    assertEquals(what == What.THROW, failed);
    assertEquals(what == What.CANCEL || what == What.INTERRUPT, ended);
    assertEquals(what == What.INTERRUPT, Thread.interrupted());
    check(step, !failed && !ended);
    if (what == What.CHANGE_CELLS) {
      present[toggled] ^= true;
      checkCells();
    }
  }

  /** One step that may be ended from outside; returns whether it was complete. */
  boolean disturbedStep() {
    what = What.NOTHING;
    long step = begin();
    boolean whole = true;
    try {
      loop.run(1);
    } catch (CancellationException e) {
      whole = false;
      Thread.interrupted();
    }
    check(step, whole);
    return whole;
  }

  private long begin() {
    for (Cell cell : all) {
      cell.visits = 0;
    }
    return loop.tick().step();
  }

  private void check(long step, boolean whole) {
    assertEquals(whole ? step + 1 : step, loop.tick().step());
    for (Cell cell : all) {
      long visits = cell.visits;
      boolean right = present[cell.index] ? visits == 1 || !whole && visits == 0 : visits == 0;
      assertTrue(right, "lost or doubled: cell=" + cell.index + ", visits=" + visits);
      assertTrue(visits == 0 || cell.doneInStep == step, "stale: cell=" + cell.index);
    }
  }

  private void checkCells() {
    int next = 0;
    for (Cell cell : all) {
      assertEquals(present[cell.index], map.contains(key(cell.index)));
      if (present[cell.index]) {
        assertSame(cell, map.cellAt(next++));
      }
    }
    assertEquals(next, map.size());
  }
}
