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
 * Two workers that pull from home and then from each other claim every task, each once.
 *
 * <p>Result: tasks claimed by worker 0, by worker 1, and tasks not claimed exactly once.
 */
@JCStressTest
@Outcome(id = "[0-4], [0-4], 0", expect = ACCEPTABLE, desc = "Each task claimed once.")
@Outcome(expect = FORBIDDEN, desc = "A task lost or claimed twice.")
@State
public class ClaimStressTest {
  private final PullTickets tickets = new PullTickets(2);
  private final Claims claims0 = new Claims(4);
  private final Claims claims1 = new Claims(4);

  /** Opens a pass of two tasks per worker. */
  public ClaimStressTest() {
    tickets.open(1, new int[] {2, 4}, Handout.PULL);
  }

  /** Worker 0. */
  @Actor
  public void worker0(III_Result r) {
    r.r1 = claims0.pull(tickets, 0, 1);
  }

  /** Worker 1. */
  @Actor
  public void worker1(III_Result r) {
    r.r2 = claims1.pull(tickets, 1, 0);
  }

  /** Looks at every task. */
  @Arbiter
  public void count(III_Result r) {
    r.r3 = Claims.notOnce(claims0, claims1);
  }
}
