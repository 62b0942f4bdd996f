package org.hdispatch.dispatch;

/** The tasks that one worker has claimed. */
final class Claims {
  private final int[] times;

  Claims(int tasks) {
    times = new int[tasks];
  }

  /** Claims from the home segment and then from another until none is left; returns how many. */
  int pull(PullTickets tickets, int home, int other) {
    int claimed = 0;
    for (int left = tickets.claimHome(home); left > 0; left = tickets.claimHome(home)) {
      times[tickets.end(home) - left]++;
      claimed++;
    }
    return claimed + steal(tickets, other);
  }

  /** Claims from a segment that is not home until none is left; returns how many. */
  int steal(PullTickets tickets, int segment) {
    int claimed = 0;
    for (int left = tickets.claimFrom(segment); left > 0; left = tickets.claimFrom(segment)) {
      times[tickets.end(segment) - left]++;
      claimed++;
    }
    return claimed;
  }

  /** Number of tasks that the two have not claimed exactly once. */
  static int notOnce(Claims a, Claims b) {
    int count = 0;
    for (int index = 0; index < a.times.length; index++) {
      count += a.times[index] + b.times[index] == 1 ? 0 : 1;
    }
    return count;
  }

  /** Number of tasks claimed more than once. */
  int twice() {
    int count = 0;
    for (int each : times) {
      count += each > 1 ? 1 : 0;
    }
    return count;
  }
}
