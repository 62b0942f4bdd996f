package org.hdispatch.dispatch;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.III_Result;

/**
 * A drain of an earlier pass leaves the pass opened meanwhile alone: the ticket holds the epoch.
 *
 * <p>Result: tasks of pass 1 claimed (-1 if it never ended), tasks drained, tasks of pass 2 found
 * at the end.
 */
@JCStressTest
@Outcome(id = "1, 0, 1", expect = ACCEPTABLE, desc = "The drain came too late.")
@Outcome(id = "0, 1, 1", expect = ACCEPTABLE, desc = "The drain ended pass 1.")
@Outcome(expect = FORBIDDEN, desc = "The drain touched pass 2, or a task was lost.")
@State
public class DrainOldPassStressTest {
  private final PullTickets tickets = new PullTickets(1);
  private final int[] ends = {1};

  /** Opens pass 1. */
  public DrainOldPassStressTest() {
    tickets.open(1, ends, Handout.PULL);
  }

  /** Does pass 1 and opens pass 2, which differs in nothing but its number. */
  @Actor
  public void caller(III_Result r) {
    if (tickets.claimHome(0) > 0) {
      r.r1 = 1;
      tickets.finish(1);
    }
    if (!Patience.untilFinished(tickets)) {
      r.r1 = -1;
      return;
    }
    tickets.open(2, ends, Handout.PULL);
  }

  /** Takes pass 1 back. */
  @Actor
  public void drain(III_Result r) {
    r.r2 = tickets.drain(1);
    if (r.r2 > 0) {
      tickets.finish(r.r2);
    }
  }

  /** Counts what is left of pass 2. */
  @Arbiter
  public void count(III_Result r) {
    r.r3 = tickets.drain(2);
    if (!tickets.finish(1)) {
      r.r3 = -1;
    }
  }
}
