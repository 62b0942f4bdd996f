package org.hdispatch.dispatch;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.IIII_Result;

/**
 * A task is either claimed or drained, and exactly one party finishes the last.
 *
 * <p>Result: tasks claimed, tasks drained, tasks claimed twice, and how often {@code finish} said
 * that these were the last (-1 if the pass is not finished at the end).
 */
@JCStressTest
@Outcome(id = "4, 0, 0, 1", expect = ACCEPTABLE, desc = "The worker got all.")
@Outcome(
    id = {"3, 1, 0, 1", "2, 2, 0, 1", "1, 3, 0, 1"},
    expect = ACCEPTABLE,
    desc = "Shared.")
@Outcome(id = "0, 4, 0, 1", expect = ACCEPTABLE, desc = "The drain got all.")
@Outcome(expect = FORBIDDEN, desc = "A task lost or doubled, or not one end.")
@State
public class DrainStressTest {
  private final PullTickets tickets = new PullTickets(2);
  private final Claims claims = new Claims(4);
  private boolean workerLast;
  private boolean drainLast;

  /** Opens a pass of two tasks at the worker's home and two elsewhere. */
  public DrainStressTest() {
    tickets.open(1, new int[] {2, 4}, Handout.PULL);
  }

  /** Pulls, as a worker does. */
  @Actor
  public void worker(IIII_Result r) {
    r.r1 = claims.pull(tickets, 0, 1);
    workerLast = r.r1 > 0 && tickets.finish(r.r1);
  }

  /** Takes back, as cancel, failure and close do. */
  @Actor
  public void drain(IIII_Result r) {
    r.r2 = tickets.drain(1);
    drainLast = r.r2 > 0 && tickets.finish(r.r2);
  }

  /** Looks at every task, and counts the ends. */
  @Arbiter
  public void count(IIII_Result r) {
    r.r3 = claims.twice();
    r.r4 = tickets.finished() ? (workerLast ? 1 : 0) + (drainLast ? 1 : 0) : -1;
  }
}
