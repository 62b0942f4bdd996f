package org.hdispatch.porous.pore;

import java.util.Arrays;

/**
 * Clusters of runs: a union-find forest that also knows which trees span the box.
 *
 * <p>With windings, each run keeps how many periods beyond its parent it lies, and a tree in which
 * two ways between the same runs disagree winds around the axis.
 */
final class RunForest {
  private static final byte FIRST = 1;
  private static final byte LAST = 2;
  private static final byte WINDS = 4;

  /** Parent of a run; of a root, minus the number of runs in its tree. */
  private final int[] parent;

  /** Periods from the parent to the run; empty without windings. */
  private final int[] winding;

  /** What a tree touches, valid at its root. */
  private final byte[] marks;

  RunForest(int runs, boolean windings) {
    parent = new int[runs];
    Arrays.fill(parent, -1);
    winding = windings ? new int[runs] : new int[0];
    marks = new byte[runs];
  }

  /** Root of a run; halves the path on the way. */
  int root(int run) {
    int at = run;
    while (parent[at] >= 0) {
      int up = parent[at];
      if (parent[up] >= 0) {
        if (winding.length > 0) {
          winding[at] += winding[up];
        }
        parent[at] = parent[up];
        at = parent[at];
      } else {
        at = up;
      }
    }
    return at;
  }

  /** Joins two runs that touch; {@code to} lies {@code step} periods beyond {@code from}. */
  void join(int from, int to, int step) {
    int a = root(from);
    int b = root(to);
    if (winding.length == 0) {
      if (a != b) {
        hang(a, b, 0);
      }
      return;
    }
    int between = fromRoot(from) + step - fromRoot(to); // of root b beyond root a
    if (a != b) {
      hang(a, b, between);
    } else if (between != 0) {
      marks[a] |= WINDS;
    }
  }

  /** Hangs the smaller tree under the larger; root b lies {@code between} periods beyond root a. */
  private void hang(int a, int b, int between) {
    int above = parent[a] <= parent[b] ? a : b;
    int below = above == a ? b : a;
    parent[above] += parent[below];
    parent[below] = above;
    marks[above] |= marks[below];
    if (winding.length > 0) {
      winding[below] = below == b ? between : -between;
    }
  }

  /** Periods from the root of a run to the run. */
  private int fromRoot(int run) {
    int sum = 0;
    for (int at = run; parent[at] >= 0; at = parent[at]) {
      sum += winding[at];
    }
    return sum;
  }

  void touch(int run, boolean first, boolean last) {
    marks[root(run)] |= (byte) ((first ? FIRST : 0) | (last ? LAST : 0));
  }

  /** Whether the tree of a root spans the axis. */
  boolean spans(int root) {
    return (marks[root] & WINDS) != 0 || (marks[root] & (FIRST | LAST)) == (FIRST | LAST);
  }
}
