package org.hdispatch.bench.peer;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.function.Function;
import org.hdispatch.dispatch.Handout;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

/** A peer that left cells out would look fast. */
class SweeperTest {
  private static final int CELLS = 100;
  private static final int STEPS = 50;

  @Test
  void processesEveryCellOncePerStep() {
    for (int n = 1; n <= 3; n++) {
      int workers = n;
      List<Function<CellTask, Sweeper>> all =
          List.of(
              task -> new SequentialSweeper(CELLS, task),
              task ->
                  new StreamSweeper(
                      workers == 1 ? 1 : ForkJoinPool.getCommonPoolParallelism() + 1, CELLS, task),
              task -> new InvokeAllSweeper(workers, CELLS, task),
              task -> new BarrierSweeper(workers, CELLS, task),
              task -> new DispatcherSweeper(workers, CELLS, Handout.PULL, task),
              task -> new DispatcherSweeper(workers, CELLS, Handout.STATIC, task));
      for (Function<CellTask, Sweeper> each : all) {
        Assertions.assertTimeoutPreemptively(
            Duration.ofMinutes(1), () -> processesEveryCellOncePerStep(each));
      }
    }
  }

  private static void processesEveryCellOncePerStep(Function<CellTask, Sweeper> of) {
    AtomicIntegerArray visits = new AtomicIntegerArray(CELLS);
    try (Sweeper sweeper = of.apply(visits::incrementAndGet)) {
      sweeper.run(STEPS);
      sweeper.run(1);
      for (int cell = 0; cell < CELLS; cell++) {
        assertEquals(
            STEPS + 1, visits.get(cell), sweeper.getClass().getSimpleName() + ", cell " + cell);
      }
    }
  }
}
