package org.hdispatch.dispatch;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;

/**
 * Tickets for the tasks of one pass: who claims a ticket runs that task, once.
 *
 * <p>The tasks 0 to n - 1 are cut into one segment per worker. Each segment has a word of its own,
 * so that workers at home do not share a cache line; a worker whose home is empty takes from the
 * other segments. A word holds {@code epoch << 33 | homeOnly << 32 | remaining} and counts down, so
 * that a worker that comes late, with its mind still in an earlier pass, can never claim a stale
 * task: it gets a task of the pass that is open now, or none.
 *
 * <p><b>Memory order.</b> (1) What the caller wrote before {@link #open} is visible to whoever
 * claims, because a claim is an atomic read-modify-write of the word that {@code open} released.
 * (2) A claim pins the pass: {@code pending} cannot reach zero before the claimant has subtracted
 * its tasks, so nothing that belongs to the pass changes under a live claim. (3) What a task wrote
 * happens before the subtraction from {@code pending}, and the caller's acquiring read of zero sees
 * all of them: one synchronisation per pass. (4) Failed claims at home take a word below zero,
 * where the lower 32 bits stay negative until the next {@code open} overwrites it.
 */
final class PullTickets {
  private static final VarHandle WORD = MethodHandles.arrayElementVarHandle(long[].class);

  /** Longs between two hot words: 128 bytes, for the adjacent-line prefetch. */
  private static final int STRIDE = 16;

  private static final int PENDING = STRIDE;
  private static final int FIRST_TICKET = 2 * STRIDE;
  private static final long HOME_ONLY = 1L << 32;
  private static final int EPOCH_SHIFT = 33;
  private static final long EPOCH_MASK = (1L << 64 - EPOCH_SHIFT) - 1;

  // The JVM links a call of a VarHandle when it is first made, and allocates for that. All others
  // are made in the first pass; this one only when somebody steals, which may be much later.
  static {
    WORD.compareAndSet(new long[1], 0, 0L, 0L);
  }

  private final int segments;
  private final long[] words;

  // Written by the caller between passes, read under a claim.
  private int[] segmentEnds;

  PullTickets(int segments) {
    this.segments = segments;
    words = new long[FIRST_TICKET + (segments + 1) * STRIDE];
  }

  /**
   * Cuts the tasks 0 to {@code tasks - 1} into segments, equal to within one, and sets their ends.
   */
  static void cut(int tasks, int[] ends) {
    for (int segment = 0; segment < ends.length; segment++) {
      ends[segment] = (int) ((long) tasks * (segment + 1) / ends.length);
    }
  }

  /**
   * Hands out the tasks of a pass.
   *
   * @param epoch number of the pass, one more than that of the pass before; kept modulo 2^31
   * @param ends end of each segment; the last is the number of tasks
   */
  void open(long epoch, int[] ends, Handout handout) {
    segmentEnds = ends;
    WORD.setOpaque(words, PENDING, (long) ends[segments - 1]);
    long flags = epoch << EPOCH_SHIFT | (handout == Handout.STATIC ? HOME_ONLY : 0);
    int start = 0;
    for (int segment = 0; segment < segments; segment++) {
      WORD.setRelease(words, ticket(segment), flags | ends[segment] - start);
      start = ends[segment];
    }
  }

  /**
   * Claims a task from the worker's own segment.
   *
   * @return how many were left there with this one: the task is {@code end(worker)} less that
   *     number; not above 0 if none was left
   */
  int claimHome(int worker) {
    return (int) (long) WORD.getAndAdd(words, ticket(worker), -1L);
  }

  /** Claims a task from another worker's segment: as {@link #claimHome}, 0 if none may be had. */
  int claimFrom(int segment) {
    while (true) {
      long word = (long) WORD.getOpaque(words, ticket(segment));
      if ((int) word <= 0 || (word & HOME_ONLY) != 0) {
        return 0;
      }
      if (WORD.compareAndSet(words, ticket(segment), word, word - 1)) {
        return (int) word;
      }
    }
  }

  /** End of a segment of the open pass; for whoever holds a claim, which pins the pass. */
  int end(int segment) {
    return segmentEnds[segment];
  }

  /**
   * Counts claimed tasks as done.
   *
   * @return whether these were the last of the pass
   */
  boolean finish(int tasks) {
    return (long) WORD.getAndAdd(words, PENDING, (long) -tasks) == tasks;
  }

  /** Whether every task of the pass is done. */
  boolean finished() {
    return (long) WORD.getVolatile(words, PENDING) == 0;
  }

  /**
   * Takes back every task of the given pass that nobody has claimed. Safe from any thread at any
   * time: it leaves later passes alone.
   *
   * @return how many were taken back; the taker must {@link #finish} them
   */
  int drain(long epoch) {
    int drained = 0;
    for (int segment = 0; segment < segments; segment++) {
      while (true) {
        long word = (long) WORD.getVolatile(words, ticket(segment));
        int remaining = (int) word;
        if (remaining <= 0 || word >>> EPOCH_SHIFT != (epoch & EPOCH_MASK)) {
          break;
        }
        if (WORD.compareAndSet(words, ticket(segment), word, word - remaining)) {
          drained += remaining;
          break;
        }
      }
    }
    return drained;
  }

  private static int ticket(int segment) {
    return FIRST_TICKET + segment * STRIDE;
  }
}
