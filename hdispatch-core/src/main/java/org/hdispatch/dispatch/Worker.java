package org.hdispatch.dispatch;

/**
 * An enduring thread: waits for a pass, pulls its tasks one at a time until none is left, waits for
 * the next. Worker 0 has no thread of its own: the caller of the loop does its work.
 *
 * <p>A pass ends when all tasks are done, not when all workers have looked in ("lazy join"): a
 * worker that is not scheduled, or wakes too late, holds nobody up.
 */
final class Worker implements Runnable {
  private final int id;
  private final int workers;
  private final Crew crew;
  private final PullTickets tickets;
  private final Signals signals;

  // Written by this worker under a claim, read by the caller between passes.
  private long cells;
  private long stolen;
  private long busyNanos;

  Worker(int id, int workers, Crew crew, PullTickets tickets, Signals signals) {
    this.id = id;
    this.workers = workers;
    this.crew = crew;
    this.tickets = tickets;
    this.signals = signals;
  }

  @Override
  public void run() {
    long epoch = 0;
    while (!crew.closed()) {
      pull();
      epoch = signals.awaitOther(epoch, id);
    }
  }

  /** Claims and runs tasks, from the home segment and then from the others, until none is left. */
  void pull() {
    int done = 0; // the cells taken back after a failure included
    int processed = 0;
    int fromOthers = 0;
    long begin = 0;
    for (int turn = 0; turn < workers; turn++) {
      int segment = (id + turn) % workers;
      while (true) {
        int index = turn == 0 ? tickets.claimHome(id) : tickets.claimFrom(segment);
        if (index < 0) {
          break;
        }
        if (done == 0) {
          begin = System.nanoTime();
        }
        done += 1 + crew.runTask(index, id);
        processed++;
        fromOthers += turn == 0 ? 0 : 1;
      }
    }
    if (done > 0) {
      cells += processed;
      stolen += fromOthers;
      busyNanos += System.nanoTime() - begin;
      finish(done);
    }
  }

  private void finish(int tasks) {
    if (tickets.finish(tasks)) {
      signals.finished();
    }
  }

  long cells() {
    return cells;
  }

  long stolen() {
    return stolen;
  }

  long busyNanos() {
    return busyNanos;
  }
}
