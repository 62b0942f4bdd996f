package org.hdispatch.bench.peer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicIntegerArray;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A peer that left cells out would look fast. */
class SweeperTest {
  private static final int CELLS = 100;
  private static final int STEPS = 50;

  @ParameterizedTest
  @EnumSource
  void processesEveryCellOncePerStep(Peer peer) {
    Assumptions.assumeTrue(peer != Peer.VIRTUAL_THREADS || Runtime.version().feature() >= 21);
    for (int workers : numbersOfWorkers(peer)) {
      assertTimeoutPreemptively(
          Duration.ofMinutes(1), () -> processesEveryCellOncePerStep(peer, workers));
    }
  }

  private static void processesEveryCellOncePerStep(Peer peer, int workers) {
    AtomicIntegerArray visits = new AtomicIntegerArray(CELLS);
    try (Sweeper sweeper = peer.start(workers, CELLS, visits::incrementAndGet)) {
      sweeper.run(STEPS);
      sweeper.run(1);
      for (int cell = 0; cell < CELLS; cell++) {
        assertEquals(STEPS + 1, visits.get(cell), "workers " + workers + ", cell " + cell);
      }
    }
  }

  /** Where the threads are the JVM's, there are as many as it has. */
  private static int[] numbersOfWorkers(Peer peer) {
    int common = ForkJoinPool.getCommonPoolParallelism() + 1;
    return switch (peer) {
      case STREAM, FORK_JOIN -> new int[] {1, common};
      case VIRTUAL_THREADS -> new int[] {Runtime.getRuntime().availableProcessors()};
      default -> new int[] {1, 2, 3};
    };
  }

  @Test
  void refusesThreadsThatTheJvmDoesNotHave() {
    for (Peer peer : new Peer[] {Peer.STREAM, Peer.FORK_JOIN}) {
      assertThrows(IllegalArgumentException.class, () -> peer.start(1000, CELLS, cell -> {}));
    }
    Class<? extends RuntimeException> refusal =
        Runtime.version().feature() < 21
            ? UnavailablePeerException.class
            : IllegalArgumentException.class;
    assertThrows(refusal, () -> Peer.VIRTUAL_THREADS.start(1000, CELLS, cell -> {}));
  }
}
