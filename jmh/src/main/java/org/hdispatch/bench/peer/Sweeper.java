package org.hdispatch.bench.peer;

/**
 * Something that processes every cell once in each step. A step begins when the one before has
 * ended.
 */
public interface Sweeper extends AutoCloseable {
  /** Runs this many steps; one call at a time. */
  void run(int steps);

  /** Ends its threads. */
  @Override
  void close();
}
