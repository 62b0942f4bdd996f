package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.function.IntToLongFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HeaviestFirstTest {
  private static final int TASKS = 100;

  private static HeaviestFirst order(int segments) {
    HeaviestFirst order = new HeaviestFirst(segments);
    order.reset(TASKS);
    return order;
  }

  /** A pass over tasks of given cost; returns the order in which they came. */
  private static int[] pass(HeaviestFirst order, long[] nanos) {
    int[] ran = new int[TASKS];
    for (int index = 0; index < TASKS; index++) {
      ran[index] = order.taskAt(index);
      if (order.measuring()) {
        order.measured(ran[index], nanos[ran[index]]);
      }
    }
    order.passed();
    return ran;
  }

  private static long[] costs(IntToLongFunction cost) {
    return IntStream.range(0, TASKS).mapToLong(cost).toArray();
  }

  private static int[] keyOrder() {
    return IntStream.range(0, TASKS).toArray();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 8})
  void everySegmentRunsFromHeavyToLight(int segments) {
    long[] nanos = costs(n -> n % 7 == 3 ? 100_000 : n % 3 == 0 ? 0 : 5_000);
    HeaviestFirst order = order(segments);
    assertArrayEquals(keyOrder(), pass(order, nanos));
    int[] ran = pass(order, nanos);
    assertArrayEquals(keyOrder(), IntStream.of(ran).sorted().toArray());
    int heavy = (int) Arrays.stream(nanos).filter(n -> n == 100_000).count();
    int start = 0;
    for (int end : order.segmentEnds()) {
      long heavyHere = 0;
      for (int n = start; n < end; n++) {
        long cost = nanos[ran[n]];
        heavyHere += cost == 100_000 ? 1 : 0;
        if (n > start) {
          long before = nanos[ran[n - 1]];
          assertTrue(before > cost || before == cost && ran[n - 1] < ran[n]);
        }
      }
      assertTrue(heavyHere == heavy / segments || heavyHere == heavy / segments + 1);
      start = end;
    }
    assertEquals(TASKS, start);
  }

  @Test
  void equalTasksStayInKeyOrder() {
    long[] nanos = costs(n -> 1_100 + n % 2);
    HeaviestFirst order = order(2);
    pass(order, nanos);
    assertArrayEquals(keyOrder(), pass(order, nanos));
    assertArrayEquals(new int[] {50, 100}, order.segmentEnds());
  }

  @Test
  void measuresAgainAfterSixtyFourPassesAndAfterAChange() {
    long[] nanos = new long[TASKS];
    HeaviestFirst order = order(1);
    pass(order, nanos);
    nanos[99] = 1_000_000;
    for (int n = 1; n <= 64; n++) { // the last one measures
      assertArrayEquals(keyOrder(), pass(order, nanos));
    }
    assertEquals(99, pass(order, nanos)[0]);
    order.reset(TASKS);
    assertArrayEquals(keyOrder(), pass(order, nanos));
    assertEquals(99, pass(order, nanos)[0]);
  }
}
