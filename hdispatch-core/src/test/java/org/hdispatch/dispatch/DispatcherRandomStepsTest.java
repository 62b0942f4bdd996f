package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Random steps with exceptions, cancels, interrupts and changing cells thrown in: no cell is lost,
 * doubled or run in the wrong step, no exception is lost, and the dispatcher goes on.
 */
class DispatcherRandomStepsTest {
  private static final long SEED = 20100823;

  @ParameterizedTest
  @CsvSource({
    "1, PULL, SPIN_THEN_PARK",
    "2, PULL, SPIN_THEN_PARK",
    "2, STATIC, SPIN_THEN_PARK",
    "2, HEAVIEST_FIRST, PARK",
    "3, PULL, PARK",
    "5, PULL, SPIN_THEN_PARK",
    "5, STATIC, PARK"
  })
  @Timeout(300)
  void everyCellExactlyOnce(int workers, Handout handout, WaitPolicy policy) {
    randomSteps(10_000, workers, handout, policy);
  }

  /** More workers than most machines have processors; 1.05 million steps in all. */
  @ParameterizedTest
  @CsvSource({
    "1, PULL, SPIN_THEN_PARK",
    "2, PULL, SPIN_THEN_PARK",
    "2, PULL, PARK",
    "2, HEAVIEST_FIRST, SPIN_THEN_PARK",
    "3, STATIC, PARK",
    "5, PULL, SPIN_THEN_PARK",
    "9, PULL, PARK"
  })
  @Tag("validation")
  @Timeout(600)
  void everyCellExactlyOnceInAMillionSteps(int workers, Handout handout, WaitPolicy policy) {
    randomSteps(150_000, workers, handout, policy);
  }

  private static void randomSteps(int steps, int workers, Handout handout, WaitPolicy policy) {
    Random random = new Random(SEED + workers);
    try (Dispatcher dispatcher =
        Dispatcher.builder().workers(workers).handout(handout).waitPolicy(policy).build()) {
      int[] sizes = {1, 7, 64, 257};
      RandomRow[] rows = new RandomRow[sizes.length];
      for (int n = 0; n < sizes.length; n++) {
        rows[n] = new RandomRow(dispatcher, sizes[n]);
      }
      for (int step = 0; step < steps; step++) {
        rows[random.nextInt(rows.length)].step(random);
      }
    }
  }

  /** Cancels and interrupts that come from outside, at any moment between and within passes. */
  @ParameterizedTest
  @CsvSource({"1, PARK", "2, SPIN_THEN_PARK", "3, PARK"})
  @Timeout(120)
  void outsideCancelsLeaveEveryCellOnceOrNotAtAll(int workers, WaitPolicy policy) {
    try (Dispatcher dispatcher = Dispatcher.builder().workers(workers).waitPolicy(policy).build()) {
      RandomRow row = new RandomRow(dispatcher, 64);
      Thread caller = Thread.currentThread();
      AtomicBoolean over = new AtomicBoolean();
      Thread outside = new Thread(() -> disturb(row.loop(), caller, over));
      outside.start();
      int ended = 0;
      for (int step = 0; step < 20_000; step++) {
        ended += row.disturbedStep() ? 0 : 1;
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
}
