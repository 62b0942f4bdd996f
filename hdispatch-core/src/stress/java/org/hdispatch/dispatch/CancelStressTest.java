package org.hdispatch.dispatch;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import java.lang.invoke.VarHandle;
import java.util.concurrent.atomic.AtomicLong;
import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.III_Result;

/**
 * A cancel while a pass is opened takes its tasks back, by one hand or the other (Dekker's
 * pattern).
 *
 * <p>The protocol of the dispatcher, with its primitives but not with its code: the caller opens,
 * says so, and reads the flag; who cancels (or closes) raises the flag and reads which pass is
 * open.
 *
 * <p>Result: tasks taken back by the caller, by the canceller, and how often {@code finish} said
 * that these were the last.
 */
@JCStressTest
@Outcome(id = "2, 0, 1", expect = ACCEPTABLE, desc = "The caller saw the flag.")
@Outcome(id = "0, 2, 1", expect = ACCEPTABLE, desc = "The canceller saw the pass.")
@Outcome(id = "1, 1, 1", expect = ACCEPTABLE, desc = "Both, a segment each.")
@Outcome(expect = FORBIDDEN, desc = "The pass goes on although it was cancelled.")
@State
public class CancelStressTest {
  private final PullTickets tickets = new PullTickets(2);
  private volatile boolean cancelled;
  private final AtomicLong openPass = new AtomicLong();
  private boolean callerLast;
  private boolean cancellerLast;

  /** Opens a pass of one task per worker. */
  @Actor
  public void caller(III_Result r) {
    tickets.open(1, new int[] {1, 2}, Handout.PULL);
    openPass.setRelease(1);
    VarHandle.fullFence();
    if (cancelled) {
      r.r1 = tickets.drain(1);
      callerLast = r.r1 > 0 && tickets.finish(r.r1);
    }
  }

  /** Cancels. */
  @Actor
  public void canceller(III_Result r) {
    cancelled = true;
    r.r2 = tickets.drain(openPass.get());
    cancellerLast = r.r2 > 0 && tickets.finish(r.r2);
  }

  /** Counts the ends. */
  @Arbiter
  public void count(III_Result r) {
    r.r3 = (callerLast ? 1 : 0) + (cancellerLast ? 1 : 0);
  }
}
