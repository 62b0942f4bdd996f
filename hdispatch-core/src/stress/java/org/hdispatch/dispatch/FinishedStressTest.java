package org.hdispatch.dispatch;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.I_Result;

/**
 * What a task wrote is visible to whoever sees the pass finished (memory order 3), also when
 * another's {@code finish} came last.
 *
 * <p>Result: what the caller read of the worker's task (-1 if the pass was not finished).
 */
@JCStressTest
@Outcome(id = "-1", expect = ACCEPTABLE, desc = "Not finished.")
@Outcome(id = "1", expect = ACCEPTABLE, desc = "Finished, and seen.")
@Outcome(expect = FORBIDDEN, desc = "Finished, but not seen.")
@State
public class FinishedStressTest {
  private final PullTickets tickets = new PullTickets(2);
  private int written;

  /** Opens a pass of one task per worker. */
  public FinishedStressTest() {
    tickets.open(1, new int[] {1, 2}, Handout.PULL);
  }

  /** Does its task. */
  @Actor
  public void worker() {
    tickets.claimHome(1);
    written = 1;
    tickets.finish(1);
  }

  /** Does its own task, and looks whether that was all. */
  @Actor
  public void caller(I_Result r) {
    tickets.claimHome(0);
    tickets.finish(1);
    r.r1 = tickets.finished() ? written : -1;
  }
}
