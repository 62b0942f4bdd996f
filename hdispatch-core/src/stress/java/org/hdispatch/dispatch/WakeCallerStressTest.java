package org.hdispatch.dispatch;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.IZ_Result;

/**
 * A caller that parks while the last task is finished wakes, and sees what the task wrote (park and
 * wake are Dekker's pattern).
 *
 * <p>Result: what the caller read, and whether its wake-up was lost.
 */
@JCStressTest
@Outcome(id = "1, false", expect = ACCEPTABLE, desc = "Awake.")
@Outcome(expect = FORBIDDEN, desc = "A wake-up lost, or something stale.")
@State
public class WakeCallerStressTest {
  private final PullTickets tickets = new PullTickets(2);
  private final Signals signals = new Signals(2, WaitPolicy.PARK);
  private final Awakening awakening = new Awakening();
  private int written;

  /** Opens a pass of one task, the worker's. */
  public WakeCallerStressTest() {
    tickets.open(1, new int[] {0, 1}, Handout.PULL);
  }

  /** Waits for the end of the pass. */
  @Actor
  public void caller(IZ_Result r) {
    Awakening.dropPermit();
    signals.register(0, Thread.currentThread());
    while (!tickets.finished()) {
      signals.awaitFinished(tickets);
    }
    r.r1 = written;
    awakening.awake();
  }

  /** Does the task. */
  @Actor
  public void worker(IZ_Result r) {
    tickets.claimHome(1);
    written = 1;
    if (tickets.finish(1)) {
      signals.finished();
    }
    r.r2 = awakening.lost(signals, 0);
  }
}
