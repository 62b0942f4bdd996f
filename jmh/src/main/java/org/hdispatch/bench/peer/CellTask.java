package org.hdispatch.bench.peer;

/** The work on one cell. */
@FunctionalInterface
public interface CellTask {
  /**
   * Processes one cell.
   *
   * @param cell its number, from 0
   */
  void process(int cell);
}
