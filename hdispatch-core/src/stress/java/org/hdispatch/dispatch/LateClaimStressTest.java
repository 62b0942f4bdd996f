package org.hdispatch.dispatch;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.IIZ_Result;

/**
 * A claim pins its pass (memory order 2): while one pass ends and the next opens, a claim yields a
 * task of the one with its payload, or a task of the other with its payload, or none.
 *
 * <p>Result: what the caller saw when it did the only task of pass 1 (0 if it did not get it, -1 if
 * the pass never ended), what the worker saw under its claim (0 if it got none), and whether pass 2
 * ends with its only task.
 */
@JCStressTest
@Outcome(
    id = "1, 0, true",
    expect = ACCEPTABLE,
    desc = "The caller did pass 1; the worker got none.")
@Outcome(id = "1, 2, true", expect = ACCEPTABLE, desc = "The caller did pass 1, the worker pass 2.")
@Outcome(id = "0, 1, true", expect = ACCEPTABLE, desc = "The worker did pass 1.")
@Outcome(expect = FORBIDDEN, desc = "A task lost, done twice, or done with another's payload.")
@State
public class LateClaimStressTest {
  private final PullTickets tickets = new PullTickets(2);
  private final int[] ends = {1, 1};
  private int payload = 1;

  /** Opens pass 1, of one task. */
  public LateClaimStressTest() {
    tickets.open(1, ends, Handout.PULL);
  }

  /** Pulls at home, waits for the end of pass 1, opens pass 2. */
  @Actor
  public void caller(IIZ_Result r) {
    if (tickets.claimHome(0) > 0) {
      r.r1 = payload;
      tickets.finish(1);
    }
    if (!Patience.untilFinished(tickets)) {
      r.r1 = -1;
      return;
    }
    payload = 2;
    tickets.open(2, ends, Handout.PULL);
  }

  /** Takes from the caller's segment. */
  @Actor
  public void worker(IIZ_Result r) {
    if (tickets.claimFrom(0) > 0) {
      r.r2 = payload;
      tickets.finish(1);
    }
  }

  /** Takes the task of pass 2 back if the worker did not do it. */
  @Arbiter
  public void rest(IIZ_Result r) {
    int rest = tickets.drain(2);
    r.r3 = rest > 0 ? tickets.finish(rest) : tickets.finished();
  }
}
