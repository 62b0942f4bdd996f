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
 * A worker that comes late, while the next pass is being opened, gets a task of that pass and sees
 * what the caller wrote before it (memory order 1), or gets none (4).
 *
 * <p>Result: index and payload of a claim at home, of a claim elsewhere, each as {@code index * 10
 * + payload}, -1 if none; tasks left at the end, and whether {@code finish} found all tasks there.
 */
@JCStressTest
@Outcome(id = "-1, -1, 4, 1", expect = ACCEPTABLE, desc = "None: too early.")
@Outcome(id = "-1, 2, 3, 1", expect = ACCEPTABLE, desc = "One elsewhere.")
@Outcome(id = "22, 2, 2, 1", expect = ACCEPTABLE, desc = "One at home, one elsewhere.")
@Outcome(expect = FORBIDDEN, desc = "A stale task or payload, or a task lost.")
@State
public class OpenStressTest {
  private final PullTickets tickets = new PullTickets(2);
  private int payload = 1;

  /** Runs pass 1, of one task per worker. */
  public OpenStressTest() {
    tickets.open(1, new int[] {1, 2}, Handout.PULL);
    tickets.claimHome(0);
    tickets.claimHome(1);
    tickets.finish(2);
  }

  /** Opens pass 2, of two tasks per worker. */
  @Actor
  public void caller() {
    payload = 2;
    tickets.open(2, new int[] {2, 4}, Handout.PULL);
  }

  /** Worker 1, its mind still in pass 1: tries home, then elsewhere. */
  @Actor
  public void worker(IIII_Result r) {
    int leftAtHome = tickets.claimHome(1);
    r.r1 = leftAtHome <= 0 ? -1 : (tickets.end(1) - leftAtHome) * 10 + payload;
    int left = tickets.claimFrom(0);
    r.r2 = left <= 0 ? -1 : (tickets.end(0) - left) * 10 + payload;
  }

  /** Takes the rest back and finishes the pass. */
  @Arbiter
  public void rest(IIII_Result r) {
    r.r3 = tickets.drain(2);
    r.r4 = tickets.finish(4) ? 1 : 0;
  }
}
