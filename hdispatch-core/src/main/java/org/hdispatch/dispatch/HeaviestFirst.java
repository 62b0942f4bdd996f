package org.hdispatch.dispatch;

import java.util.Arrays;

/**
 * An order of tasks by falling cost, as measured in an earlier pass.
 *
 * <p>Tasks of like cost form a class, a quarter of an octave wide. Classes go from heavy to light;
 * within a class the key order stays, and every segment gets an equal, unbroken part of it, so that
 * equal tasks are handed out as they would be without measuring. Nothing is allocated once the
 * arrays have grown.
 */
final class HeaviestFirst {
  private static final int PERIOD = 64; // passes from one measurement to the next
  private static final int CLASSES = 256;

  private final int[] segmentEnds;
  private final int[] nextInSegment;
  private final int[] classStarts = new int[CLASSES + 1];
  private int count;
  private long[] nanos = new long[0]; // by task
  private int[] byClass = new int[0]; // tasks, heaviest class first
  private int[] order = new int[0]; // tasks as handed out
  private int passesToMeasurement;

  HeaviestFirst(int segments) {
    segmentEnds = new int[segments];
    nextInSegment = new int[segments];
  }

  /** Begins with tasks of unknown cost, in key order. */
  void reset(int tasks) {
    count = tasks;
    if (tasks > order.length) {
      int room = Math.max(tasks, 2 * order.length);
      nanos = new long[room];
      byClass = new int[room];
      order = new int[room];
    }
    Arrays.fill(nanos, 0, count, 0);
    passesToMeasurement = 0;
    arrange();
  }

  /** Ends of the segments of the next pass. */
  int[] segmentEnds() {
    return segmentEnds;
  }

  /** The task that is handed out as number {@code index}. */
  int taskAt(int index) {
    return order[index];
  }

  /** Whether the pass in progress is one whose tasks are to be measured. */
  boolean measuring() {
    return passesToMeasurement == 0;
  }

  /** A task has taken so long. */
  void measured(int task, long taken) {
    nanos[task] = taken;
  }

  /** The pass is complete. */
  void passed() {
    if (passesToMeasurement > 0) {
      passesToMeasurement--;
      return;
    }
    passesToMeasurement = PERIOD - 1;
    arrange();
  }

  private void arrange() {
    sortByClass();
    Arrays.fill(segmentEnds, 0);
    deal(false);
    int end = 0;
    for (int segment = 0; segment < segmentEnds.length; segment++) {
      nextInSegment[segment] = end;
      end += segmentEnds[segment];
      segmentEnds[segment] = end;
    }
    deal(true);
  }

  /** Counting sort, stable. */
  private void sortByClass() {
    Arrays.fill(classStarts, 0);
    for (int n = 0; n < count; n++) {
      classStarts[classOf(nanos[n]) + 1]++;
    }
    for (int n = 0; n < CLASSES; n++) {
      classStarts[n + 1] += classStarts[n];
    }
    for (int n = 0; n < count; n++) {
      byClass[classStarts[classOf(nanos[n])]++] = n;
    }
  }

  /** Deals every class out to the segments: first counts how many each gets, then places them. */
  private void deal(boolean place) {
    int segments = segmentEnds.length;
    int turn = 0; // who is first: else the odd ones would all go to the same segment
    int start = 0;
    for (int n = 0; n < CLASSES; n++) {
      int members = classStarts[n] - start;
      for (int m = 0; m < members; m++) {
        int segment = (int) (((long) m * segments / members + turn) % segments);
        if (place) {
          order[nextInSegment[segment]++] = byClass[start + m];
        } else {
          segmentEnds[segment]++;
        }
      }
      turn = (turn + members) % segments;
      start += members;
    }
  }

  /** Class of a cost, 0 for the heaviest: four to an octave. */
  private static int classOf(long nanos) {
    long cost = Math.max(nanos, 4);
    int octave = 63 - Long.numberOfLeadingZeros(cost);
    int quarter = (int) (cost >>> octave - 2) & 3;
    return CLASSES - 1 - (4 * octave + quarter);
  }
}
