package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** A worker and a caller that park at once never sleep through a pass, its end, or the close. */
class SignalsScheduleTest {
  private static final int SCHEDULES = 3_000;

  /** The words that the threads of a dispatcher share, and as much of the threads as needs be. */
  private static final class Rig {
    final int workers;
    final PullTickets tickets;
    final Signals signals;
    final int[] segmentEnds;
    final int[] runs;

    Rig(int workers, int tasks) {
      this.workers = workers;
      tickets = new PullTickets(workers);
      signals = new Signals(workers, WaitPolicy.PARK);
      signals.register(0, Thread.currentThread());
      segmentEnds = new int[workers];
      PullTickets.cut(tasks, segmentEnds);
      runs = new int[tasks];
    }

    /** Starts a worker that stays until the end is announced. */
    Schedules.Fork worker(int id) {
      Schedules.Fork worker =
          new Schedules.Fork(
              () -> {
                long epoch = 0;
                while (epoch != -1) {
                  pull(id);
                  epoch = signals.awaitOther(epoch, id);
                }
              });
      signals.register(id, worker.thread);
      worker.start();
      return worker;
    }

    private void pull(int id) {
      int done = 0;
      for (int turn = 0; turn < workers; turn++) {
        int segment = (id + turn) % workers;
        while (true) {
          int left = turn == 0 ? tickets.claimHome(id) : tickets.claimFrom(segment);
          if (left <= 0) {
            break;
          }
          runs[tickets.end(segment) - left]++;
          done++;
        }
      }
      count(done);
    }

    private void count(int tasks) {
      if (tasks > 0 && tickets.finish(tasks)) {
        signals.finished();
      }
    }

    void open(long pass, Handout handout) {
      tickets.open(pass, segmentEnds, handout);
      signals.announce(pass);
    }

    void awaitFinished() {
      while (!tickets.finished()) {
        signals.awaitFinished(tickets);
      }
    }
  }

  @Test
  void theCallerThatPullsTooWakesWhenThePassIsDone() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          Rig rig = new Rig(2, 2);
          Schedules.Fork worker = rig.worker(1);
          rig.open(1, Handout.PULL);
          rig.pull(0);
          rig.awaitFinished();
          assertEquals(1, rig.runs[0]);
          assertEquals(1, rig.runs[1]);
          rig.signals.announce(-1);
          worker.join();
        });
  }

  /** Only the worker can run its task, so that the wake-up of a pass must not be lost. */
  @Test
  void theWorkerWakesForEveryPass() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          Rig rig = new Rig(2, 2);
          Schedules.Fork worker = rig.worker(1);
          for (int pass = 1; pass <= 2; pass++) {
            rig.open(pass, Handout.STATIC);
            rig.pull(0);
            rig.awaitFinished();
            assertEquals(pass, rig.runs[0]);
            assertEquals(pass, rig.runs[1]);
          }
          rig.signals.announce(-1);
          worker.join();
        });
  }

  @Test
  void theCallerWakesWhenTheLastTasksAreTakenBack() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          Rig rig = new Rig(2, 2);
          rig.open(1, Handout.STATIC); // nobody is worker 1: its task can only be taken back
          Schedules.Fork canceller = Schedules.fork(() -> rig.count(rig.tickets.drain(1)));
          rig.pull(0);
          rig.awaitFinished();
          assertEquals(0, rig.runs[1]);
          canceller.join();
        });
  }

  @Test
  void twoWorkersWakeForAPassAndForTheEnd() {
    Schedules.explore(
        SCHEDULES,
        () -> {
          Rig rig = new Rig(3, 3);
          Schedules.Fork first = rig.worker(1);
          Schedules.Fork second = rig.worker(2);
          rig.open(1, Handout.STATIC);
          rig.pull(0);
          rig.awaitFinished();
          for (int runs : rig.runs) {
            assertEquals(1, runs);
          }
          rig.signals.announce(-1);
          first.join();
          second.join();
        });
  }
}
