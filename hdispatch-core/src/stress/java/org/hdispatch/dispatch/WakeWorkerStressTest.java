package org.hdispatch.dispatch;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.IIZ_Result;

/**
 * A worker that parks while a pass is announced wakes, with the new epoch and with what was written
 * before the announcement (park and wake are Dekker's pattern).
 *
 * <p>Result: the epoch that the worker got, what it read, and whether its wake-up was lost.
 */
@JCStressTest
@Outcome(id = "1, 1, false", expect = ACCEPTABLE, desc = "Awake.")
@Outcome(expect = FORBIDDEN, desc = "A wake-up lost, or something stale.")
@State
public class WakeWorkerStressTest {
  private final Signals signals = new Signals(2, WaitPolicy.PARK);
  private final Awakening awakening = new Awakening();
  private int payload;

  /** Waits for an announcement. */
  @Actor
  public void worker(IIZ_Result r) {
    Awakening.dropPermit();
    signals.register(1, Thread.currentThread());
    r.r1 = (int) signals.awaitOther(0, 1);
    r.r2 = payload;
    awakening.awake();
  }

  /** Announces. */
  @Actor
  public void caller(IIZ_Result r) {
    payload = 1;
    signals.announce(1);
    r.r3 = awakening.lost(signals, 1);
  }
}
