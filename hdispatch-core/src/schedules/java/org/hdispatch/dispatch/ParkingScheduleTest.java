package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.jetbrains.lincheck.LincheckAssertionError;
import org.junit.jupiter.api.Test;

/** The model checker sees a wake-up that is lost; without this the other tests prove little. */
class ParkingScheduleTest {

  @Test
  void aSleeperThatLooksAgainIsWoken() {
    Schedules.explore(1_000, () -> wakeASleeper(true));
  }

  @Test
  void aSleeperThatDoesNotLookAgainIsLost() {
    LincheckAssertionError lost =
        assertThrows(
            LincheckAssertionError.class,
            () -> Schedules.explore(1_000, () -> wakeASleeper(false)));
    assertTrue(lost.getMessage().contains("deadlock"), lost.getMessage());
  }

  @Test
  void aSleeperWithATimeoutWakesByItself() {
    Schedules.explore(
        1_000,
        () -> {
          AtomicBoolean news = new AtomicBoolean();
          Schedules.Fork sleeper =
              Schedules.fork(
                  () -> {
                    while (!news.get()) {
                      LockSupport.parkNanos(1);
                    }
                  });
          news.set(true);
          sleeper.join();
        });
  }

  private static void wakeASleeper(boolean looksAgain) {
    AtomicBoolean news = new AtomicBoolean();
    AtomicBoolean asleep = new AtomicBoolean();
    Schedules.Fork sleeper =
        Schedules.fork(
            () -> {
              while (!news.get()) {
                asleep.set(true);
                if (!looksAgain || !news.get()) {
                  LockSupport.park();
                }
              }
            });
    news.set(true);
    if (asleep.get()) {
      LockSupport.unpark(sleeper.thread);
    }
    sleeper.join();
  }
}
