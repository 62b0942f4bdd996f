package org.hdispatch.app;

import picocli.CommandLine.Option;

/** How many threads. */
final class ThreadOptions {
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
  int threads() {
    if (threads < 1 || threads > MOST) {
      throw new UsageException("threads must number 1 to " + MOST + ": threads=" + threads);
    }
    return threads;
  }
}
