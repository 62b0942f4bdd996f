package org.hdispatch.dispatch;

/**
 * An enduring thread: waits for a pass, pulls its tasks one at a time until none is left, waits for
 * the next. Worker 0 has no thread of its own: the caller of the loop does its work.
 *
 * <p>A pass ends when all tasks are done, not when all workers have looked in ("lazy join"): a
 * worker that is not scheduled, or wakes too late, holds nobody up.
 */
final class Worker implements Runnable {
  // Places in the line of a worker, of the pull in progress.
  private static final int LINE = 16; // longs: 128 bytes before, for, and behind what is written
  private static final int TURN = LINE; // 0 at home, then the others' segments
  private static final int HOME_END = LINE + 1;
  private static final int IN_WORK = LINE + 2;
  private static final int CLAIMED = LINE + 3;
  private static final int FROM_OTHERS = LINE + 4;
  private static final int TAKEN_BACK = LINE + 5;
  // Of all pulls.
  private static final int CELLS = LINE + 6;
  private static final int STOLEN = LINE + 7;
  private static final int BUSY_NANOS = LINE + 8;

  private final int id;
  private final int workers;
  private final Crew crew;
  private final PullTickets tickets;
  private final Signals signals;

  /** All that this worker writes. The totals it writes under a claim; the caller reads those. */
  private final long[] line = new long[3 * LINE];

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

  /**
   * Claims and runs tasks, from the home segment and then from the others, until none is left. All
   * are of one pass: the first claim pins it until they are counted as done.
   */
  void pull() {
    line[TURN] = 0;
    line[CLAIMED] = 0;
    line[FROM_OTHERS] = 0;
    line[TAKEN_BACK] = 0;
    int first = first();
    if (first < 0) {
      return;
    }
    long begin = System.nanoTime();
    int rest = crew.runFrom(first, this); // apart: next() adds to what is taken back too
    line[TAKEN_BACK] += rest;
    line[CELLS] += line[CLAIMED];
    line[STOLEN] += line[FROM_OTHERS];
    line[BUSY_NANOS] += System.nanoTime() - begin;
    if (tickets.finish((int) (line[CLAIMED] + line[TAKEN_BACK]))) {
      signals.finished();
    }
  }

  private int first() {
    int remaining = tickets.claimHome(id);
    if (remaining <= 0) {
      line[TURN] = 1;
      return nextFromOthers();
    }
    int end = tickets.end(id);
    line[HOME_END] = end;
    return claimed(end - remaining);
  }

  /** Claims the next task of the pass in work: its number, or -1 if none is left. */
  int next() {
    if (id == 0 && Thread.currentThread().isInterrupted()) {
      line[TAKEN_BACK] += crew.takeRest();
    }
    if (line[TURN] == 0) {
      int end = (int) line[HOME_END]; // read before the claim: behind it, it would have to wait
      int remaining = tickets.claimHome(id);
      if (remaining > 0) {
        return claimed(end - remaining);
      }
      line[TURN] = 1;
    }
    return nextFromOthers();
  }

  private int nextFromOthers() {
    for (; line[TURN] < workers; line[TURN]++) {
      int segment = (id + (int) line[TURN]) % workers;
      int remaining = tickets.claimFrom(segment);
      if (remaining > 0) {
        line[FROM_OTHERS]++;
        return claimed(tickets.end(segment) - remaining);
      }
    }
    return -1;
  }

  private int claimed(int index) {
    line[CLAIMED]++;
    line[IN_WORK] = index;
    return index;
  }

  int id() {
    return id;
  }

  /** The task claimed last. */
  int inWork() {
    return (int) line[IN_WORK];
  }

  long cells() {
    return line[CELLS];
  }

  long stolen() {
    return line[STOLEN];
  }

  long busyNanos() {
    return line[BUSY_NANOS];
  }
}
