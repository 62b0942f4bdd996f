package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HeaviestFirstTest {
  private static final int TASKS = 100;

  /** Tasks of given cost on a clock of their own; notes in which order they ran. */
  private static final class Costly implements Task {
    final long[] nanos = new long[TASKS];
    final List<Integer> ran = new ArrayList<>();
    long now;

    @Override
    public void run(int index, int worker) {
      ran.add(index);
      now += nanos[index];
    }

    @Override
    public RuntimeException failure(int index, int worker, Throwable cause) {
      return new IllegalStateException("task " + index, cause);
    }

    int[] runBy(HeaviestFirst pass) {
      ran.clear();
      for (int index = 0; index < TASKS; index++) {
        pass.run(index, 0);
      }
      pass.passed();
      return ran.stream().mapToInt(n -> n).toArray();
    }
  }

  private static HeaviestFirst pass(Costly tasks, int workers) {
    HeaviestFirst pass = new HeaviestFirst(tasks, workers, () -> tasks.now);
    pass.reset(TASKS);
    return pass;
  }

  private static int[] keyOrder() {
    return IntStream.range(0, TASKS).toArray();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 8})
  void everySegmentRunsFromHeavyToLight(int workers) {
    Costly tasks = new Costly();
    Arrays.setAll(tasks.nanos, n -> n % 7 == 3 ? 100_000 : n % 3 == 0 ? 0 : 5_000);
    HeaviestFirst pass = pass(tasks, workers);
    assertArrayEquals(keyOrder(), tasks.runBy(pass));
    int[] order = tasks.runBy(pass);
    assertArrayEquals(keyOrder(), IntStream.of(order).sorted().toArray());
    int heavy = (int) Arrays.stream(tasks.nanos).filter(n -> n == 100_000).count();
    int start = 0;
    for (int end : pass.segmentEnds()) {
      long[] costs = IntStream.range(start, end).mapToLong(n -> tasks.nanos[order[n]]).toArray();
      for (int n = 1; n < costs.length; n++) {
        assertTrue(costs[n - 1] >= costs[n]);
        assertTrue(costs[n - 1] > costs[n] || order[start + n - 1] < order[start + n]);
      }
      long heavyHere = Arrays.stream(costs).filter(n -> n == 100_000).count();
      assertTrue(heavyHere == heavy / workers || heavyHere == heavy / workers + 1);
      start = end;
    }
    assertEquals(TASKS, start);
  }

  @Test
  void equalTasksStayInKeyOrder() {
    Costly tasks = new Costly();
    Arrays.setAll(tasks.nanos, n -> 1_000 + n % 2);
    HeaviestFirst pass = pass(tasks, 2);
    tasks.runBy(pass);
    assertArrayEquals(keyOrder(), tasks.runBy(pass));
    assertArrayEquals(new int[] {50, 100}, pass.segmentEnds());
  }

  @Test
  void measuresAgainAfterSixtyFourPasses() {
    Costly tasks = new Costly();
    HeaviestFirst pass = pass(tasks, 1);
    tasks.runBy(pass);
    tasks.nanos[99] = 1_000_000;
    for (int n = 1; n < 64; n++) {
      assertArrayEquals(keyOrder(), tasks.runBy(pass));
    }
    tasks.runBy(pass); // measures
    assertEquals(99, tasks.runBy(pass)[0]);
    pass.reset(TASKS);
    assertArrayEquals(keyOrder(), tasks.runBy(pass));
    assertEquals(99, tasks.runBy(pass)[0]);
  }

  @Test
  void namesTheTaskThatFailed() {
    Costly tasks = new Costly();
    tasks.nanos[42] = 1_000;
    HeaviestFirst pass = pass(tasks, 2);
    tasks.runBy(pass);
    assertEquals("task 42", pass.failure(0, 0, null).getMessage());
  }
}
