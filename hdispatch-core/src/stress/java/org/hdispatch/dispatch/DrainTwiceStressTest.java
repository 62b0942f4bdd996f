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
 * Two that drain the same pass take every task back once, and exactly one finishes the last.
 *
 * <p>Result: tasks drained by either, and how often {@code finish} said that these were the last
 * (-1 if the pass is not finished at the end).
 */
@JCStressTest
@Outcome(
    id = {"3, 0, 1", "2, 1, 1", "1, 2, 1", "0, 3, 1"},
    expect = ACCEPTABLE,
    desc = "Each task drained once.")
@Outcome(expect = FORBIDDEN, desc = "A task lost or drained twice, or not one end.")
@State
public class DrainTwiceStressTest {
  private final PullTickets tickets = new PullTickets(2);
  private boolean lastA;
  private boolean lastB;

  /** Opens a pass of one and two tasks. */
  public DrainTwiceStressTest() {
    tickets.open(1, new int[] {1, 3}, Handout.PULL);
  }

  /** One that takes back. */
  @Actor
  public void drainA(III_Result r) {
    r.r1 = tickets.drain(1);
    lastA = r.r1 > 0 && tickets.finish(r.r1);
  }

  /** Another. */
  @Actor
  public void drainB(III_Result r) {
    r.r2 = tickets.drain(1);
    lastB = r.r2 > 0 && tickets.finish(r.r2);
  }

  /** Counts the ends. */
  @Arbiter
  public void count(III_Result r) {
    r.r3 = tickets.finished() ? (lastA ? 1 : 0) + (lastB ? 1 : 0) : -1;
  }
}
