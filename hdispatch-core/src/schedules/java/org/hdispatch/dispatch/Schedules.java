package org.hdispatch.dispatch;

import net.bytebuddy.ByteBuddy;
import net.bytebuddy.agent.ByteBuddyAgent;
import net.bytebuddy.asm.Advice;
import net.bytebuddy.dynamic.loading.ClassReloadingStrategy;
import net.bytebuddy.matcher.ElementMatchers;
import org.jetbrains.kotlinx.lincheck.strategy.managed.modelchecking.ModelCheckingParkingTracker;
import org.jetbrains.lincheck.Lincheck;
import org.jetbrains.lincheck.LincheckAssertionError;

/**
 * Runs a piece of concurrent code under many schedules, one thread at a time: Lincheck's model
 * checker. Schedules with few switches of threads come first, and none comes twice.
 *
 * <p>The memory is sequentially consistent here: what reordering does is for jcstress to find.
 *
 * <p>Lincheck lets every {@code park} return at once, as the JDK allows, and so never sees a
 * wake-up that is lost. Here only {@code parkNanos} does; {@code park} returns after an {@code
 * unpark} or an interrupt. {@link ParkingScheduleTest} holds that.
 */
final class Schedules {
  private Schedules() {}

  static {
    ByteBuddyAgent.install();
    Class<?> parking = ModelCheckingParkingTracker.class;
    new ByteBuddy()
        .redefine(parking)
        .visit(Advice.to(NoSpuriousWakeUps.class).on(ElementMatchers.named("waitUnpark")))
        .make()
        .load(parking.getClassLoader(), ClassReloadingStrategy.fromInstalledAgent());
  }

  /**
   * Runs a block, threads that it starts included, under at most this many schedules, or {@code
   * -Dschedules.percent} of them.
   *
   * @param block everything that it changes, it makes itself; it waits for its threads
   * @throws LincheckAssertionError with the schedule, if the block threw or its threads came to a
   *     deadlock
   */
  static void explore(int atMost, Runnable block) {
    Lincheck.runConcurrentTest(
        (int) Math.ceil(atMost / 100.0 * Integer.getInteger("schedules.percent", 100)), block);
  }

  /** Starts a thread; {@link Fork#join} waits for it. */
  static Fork fork(Runnable body) {
    Fork fork = new Fork(body);
    fork.start();
    return fork;
  }

  /** A thread that hands on what it threw: Lincheck sees only what the block throws. */
  static final class Fork {
    final Thread thread;
    private Throwable thrown;

    Fork(Runnable body) {
      thread =
          new Thread(
              () -> {
                try {
                  body.run();
                } catch (RuntimeException | AssertionError e) {
                  thrown = e;
                }
              });
    }

    void start() {
      thread.start();
    }

    void join() {
      try {
        thread.join();
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
      if (thrown != null) {
        throw new AssertionError(thrown);
      }
    }
  }

  /** Goes into the method that says whether a thread must stay parked. */
  private static final class NoSpuriousWakeUps {
    @Advice.OnMethodEnter
    static void enter(@Advice.Argument(value = 1, readOnly = false) boolean mayWakeByItself) {
      boolean timed = false;
      for (StackTraceElement frame : new Throwable().getStackTrace()) {
        timed |= frame.getMethodName().equals("parkNanos");
      }
      mayWakeByItself &= timed;
    }
  }
}
