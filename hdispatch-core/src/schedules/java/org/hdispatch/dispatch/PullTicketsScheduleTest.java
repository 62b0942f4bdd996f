package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Every task of a pass is claimed or taken back once, and one thread learns that it is done. */
class PullTicketsScheduleTest {
  private static final int SCHEDULES = 3_000;

  /** What one thread did with the tickets. */
  private static final class Puller {
    final PullTickets tickets;
    final int workers;
    final int[] claimed;
    int counted; // tasks that this thread has counted as done, those taken back included
    int lasts; // how often it was told that these were the last

    Puller(PullTickets tickets, int workers, int tasks) {
      this.tickets = tickets;
      this.workers = workers;
      claimed = new int[tasks];
    }

    /** As a worker does: home first, then the others, one subtraction at the end. */
    void pull(int id) {
      int done = 0;
      for (int turn = 0; turn < workers; turn++) {
        int segment = (id + turn) % workers;
        while (true) {
          int left = turn == 0 ? tickets.claimHome(id) : tickets.claimFrom(segment);
          if (left <= 0) {
            break;
          }
          claimed[tickets.end(segment) - left]++;
          done++;
        }
      }
      count(done);
    }

    /** As a cancel does. */
    void takeBack(long epoch) {
      count(tickets.drain(epoch));
    }

    private void count(int tasks) {
      if (tasks > 0) {
        counted += tasks;
        lasts += tickets.finish(tasks) ? 1 : 0;
      }
    }
  }

  /** The pass is over, and every task in it has been counted once. */
  private static void assertDone(int tasks, PullTickets tickets, Puller... pullers) {
    int counted = 0;
    int lasts = 0;
    for (Puller each : pullers) {
      counted += each.counted;
      lasts += each.lasts;
    }
    assertEquals(tasks, counted);
    assertEquals(1, lasts);
    assertTrue(tickets.finished());
    for (int task = 0; task < tasks; task++) {
      assertTrue(claims(task, pullers) <= 1);
    }
  }

  private static int claims(int task, Puller... pullers) {
    int claims = 0;
    for (Puller each : pullers) {
      claims += each.claimed[task];
    }
    return claims;
  }

  @Test
  void twoWorkersClaimEveryTaskOnce() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          PullTickets tickets = new PullTickets(2);
          Puller home = new Puller(tickets, 2, 4);
          Puller other = new Puller(tickets, 2, 4);
          tickets.open(1, new int[] {2, 4}, Handout.PULL);
          Schedules.Fork thread = Schedules.fork(() -> other.pull(1));
          home.pull(0);
          thread.join();
          assertDone(4, tickets, home, other);
          for (int task = 0; task < 4; task++) {
            assertEquals(1, claims(task, home, other));
          }
        });
  }

  @Test
  void workersClaimOnlyTheirOwnTasksWhenHandoutIsStatic() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          PullTickets tickets = new PullTickets(2);
          Puller home = new Puller(tickets, 2, 3);
          Puller other = new Puller(tickets, 2, 3);
          tickets.open(1, new int[] {1, 3}, Handout.STATIC);
          Schedules.Fork thread = Schedules.fork(() -> other.pull(1));
          home.pull(0);
          thread.join();
          assertDone(3, tickets, home, other);
          assertEquals(1, home.counted);
          assertEquals(2, other.counted);
        });
  }

  @Test
  void everyTaskIsClaimedOrTakenBackOnce() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          PullTickets tickets = new PullTickets(2);
          Puller home = new Puller(tickets, 2, 3);
          Puller other = new Puller(tickets, 2, 3);
          Puller canceller = new Puller(tickets, 2, 3);
          tickets.open(1, new int[] {1, 3}, Handout.PULL);
          Schedules.Fork worker = Schedules.fork(() -> other.pull(1));
          Schedules.Fork thread = Schedules.fork(() -> canceller.takeBack(1));
          home.pull(0);
          worker.join();
          thread.join();
          assertDone(3, tickets, home, other, canceller);
        });
  }

  @Test
  void twoWhoTakeBackDoNotCountATaskTwice() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          PullTickets tickets = new PullTickets(2);
          Puller home = new Puller(tickets, 2, 2);
          Puller canceller = new Puller(tickets, 2, 2);
          Puller closer = new Puller(tickets, 2, 2);
          tickets.open(1, new int[] {1, 2}, Handout.PULL);
          Schedules.Fork first = Schedules.fork(() -> canceller.takeBack(1));
          Schedules.Fork second = Schedules.fork(() -> closer.takeBack(1));
          home.pull(0);
          first.join();
          second.join();
          assertDone(2, tickets, home, canceller, closer);
        });
  }

  @Test
  void takingBackALatePassLeavesTheNextAlone() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          PullTickets tickets = new PullTickets(2);
          int[] ends = new int[] {1, 2};
          Puller first = new Puller(tickets, 2, 2);
          Puller second = new Puller(tickets, 2, 2);
          Puller canceller = new Puller(tickets, 2, 2);
          tickets.open(1, ends, Handout.PULL);
          Schedules.Fork thread = Schedules.fork(() -> canceller.takeBack(1));
          first.pull(0);
          while (!tickets.finished()) {
            Thread.onSpinWait();
          }
          tickets.open(2, ends, Handout.PULL);
          assertFalse(tickets.finished());
          second.pull(0);
          assertTrue(tickets.finished());
          thread.join();
          assertEquals(2, second.counted);
          assertEquals(2, first.counted + canceller.counted);
          assertEquals(1, first.lasts + canceller.lasts);
        });
  }

  /** A worker whose mind is still in pass 1 when the caller opens pass 2. */
  @Test
  void aLateWorkerGetsATaskOfTheOpenPassOrNone() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          PullTickets tickets = new PullTickets(2);
          Puller late = new Puller(tickets, 2, 3);
          Puller caller = new Puller(tickets, 2, 3);
          tickets.open(1, new int[] {1, 2}, Handout.PULL);
          Schedules.Fork worker = Schedules.fork(() -> late.pull(1));
          caller.pull(0);
          while (!tickets.finished()) {
            Thread.onSpinWait();
          }
          tickets.open(2, new int[] {1, 3}, Handout.PULL);
          caller.pull(0);
          worker.join();
          assertTrue(tickets.finished());
          assertEquals(2 + 3, caller.counted + late.counted);
          assertEquals(2, caller.lasts + late.lasts);
          assertEquals(2, claims(0, caller, late));
          assertEquals(2, claims(1, caller, late));
          assertEquals(1, claims(2, caller, late));
        });
  }
}
