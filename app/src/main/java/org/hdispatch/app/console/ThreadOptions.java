package org.hdispatch.app.console;

import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Option;

/** How many threads. */
public final class ThreadOptions {
  private static final int MOST = 4096;

  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Threads that pull cells, the caller's included.")
  private int threads = Runtime.getRuntime().availableProcessors();

  /**
   * Their number.
   *
   * @throws UsageException if it is less than 1, or more than any machine has
   */
  public int threads() {
    if (threads < 1 || threads > MOST) {
      throw new UsageException("threads must number 1 to " + MOST + ": threads=" + threads);
    }
    return threads;
  }

  /** Some numbers of threads from 1 to the most: 1, 2, 3, 4, 6, 8, 12, 16, 24 ... */
  public static int[] upTo(int most) {
    List<Integer> counts = new ArrayList<>();
    for (int power = 1; power < most; power *= 2) {
      counts.add(power);
      if (power > 1 && power / 2 * 3 < most) {
        counts.add(power / 2 * 3);
      }
    }
    counts.add(most);
    return counts.stream().mapToInt(Integer::intValue).distinct().toArray();
  }
}
