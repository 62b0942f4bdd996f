package org.hdispatch.gc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class AllocationMeterTest {

  private static final int ARRAY = 1 << 20;
  private static final int RUNS = 3;

  private static volatile Object keptAlive;
  private static volatile double computed;

  @Test
  void seesAnArrayOfAnotherThreadToItsSize() throws InterruptedException {
    long bytes = bytesOfOneTaskOnAnotherThread(() -> keptAlive = new byte[ARRAY]);
    assertTrue(bytes >= ARRAY && bytes <= ARRAY + 24, "bytes=" + bytes); // 16 or 24 of header
  }

  @Test
  void readsExactlyZeroForAThreadThatOnlyComputes() throws InterruptedException {
    long bytes =
        bytesOfOneTaskOnAnotherThread(
            () -> {
              double sum = 0;
              for (int i = 0; i < 1_000_000; i++) {
                sum += Math.sqrt(i);
              }
              computed = sum;
            });
    assertEquals(0, bytes);
  }

  /** In one part of ten the JVM may allocate for itself, when it replaces compiled code. */
  @Test
  void allocatesNothingItselfAfterTheFirstReading() {
    AllocationMeter meter =
        new AllocationMeter(Thread.currentThread().getId(), Thread.currentThread().getId());
    long[] before = new long[2];
    long[] after = new long[2];
    meter.read(before);
    meter.read(after);
    int changed = 0;
    for (int part = 0; part < 10; part++) {
      meter.read(before);
      for (int i = 0; i < 100; i++) {
        meter.read(after);
      }
      changed += Arrays.equals(before, after) ? 0 : 1;
    }
    assertTrue(changed <= 1, "parts of the readings that allocate: " + changed);
  }

  @Test
  void readsMinusOneForAThreadThatHasEnded() throws InterruptedException {
    Thread thread = new Thread(() -> {});
    thread.start();
    thread.join();
    long[] reading = new long[1];
    new AllocationMeter(thread.getId()).read(reading);
    assertEquals(-1, reading[0]);
  }

  /**
   * Runs the task on a thread of its own, once to load classes and some times more. What the JVM
   * may allocate for itself in one of them it does not in another: the least of them counts.
   */
  private static long bytesOfOneTaskOnAnotherThread(Runnable task) throws InterruptedException {
    AtomicInteger turn = new AtomicInteger();
    Thread thread =
        new Thread(
            () -> {
              task.run();
              for (int run = 0; run < RUNS; run++) {
                turn.set(2 * run + 1);
                await(turn, 2 * run + 2);
                task.run();
              }
              turn.set(2 * RUNS + 1);
              await(turn, 2 * RUNS + 2);
            });
    thread.setDaemon(true);
    thread.start();
    AllocationMeter meter = new AllocationMeter(thread.getId());
    long[] before = new long[meter.threads()];
    long[] after = new long[meter.threads()];
    long least = Long.MAX_VALUE;
    await(turn, 1);
    for (int run = 0; run < RUNS; run++) {
      meter.read(before);
      turn.set(2 * run + 2);
      await(turn, 2 * run + 3);
      meter.read(after);
      least = Math.min(least, after[0] - before[0]);
    }
    turn.set(2 * RUNS + 2);
    thread.join();
    return least;
  }

  private static void await(AtomicInteger turn, int value) {
    while (turn.get() != value) {
      Thread.onSpinWait();
    }
  }
}
