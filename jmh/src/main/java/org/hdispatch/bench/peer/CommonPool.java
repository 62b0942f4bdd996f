package org.hdispatch.bench.peer;

import java.util.concurrent.ForkJoinPool;

/** The fork-join pool that the JVM shares out: its threads are as many as the JVM was told. */
final class CommonPool {
  private CommonPool() {}

  /**
   * Checks that {@code workers} is 1 or the common pool's threads and the caller.
   *
   * @throws IllegalArgumentException if it is neither
   */
  static void require(int workers) {
    int all = ForkJoinPool.getCommonPoolParallelism() + 1;
    if (workers != 1 && workers != all) {
      throw new IllegalArgumentException(
          "workers must be 1 or all of the common pool (set"
              + " -Djava.util.concurrent.ForkJoinPool.common.parallelism=workers-1): workers="
              + workers
              + ", all="
              + all);
    }
  }
}
