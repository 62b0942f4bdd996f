package org.hdispatch.dispatch;

import java.util.Objects;

/**
 * A named sweep over all cells. After each pass the dispatcher waits until every cell is done.
 *
 * @param name what the pass does, for errors and statistics
 * @param kernel the work on one cell
 * @param <C> type of a cell
 * @param <S> type of the scratch
 */
public record Pass<C, S>(String name, CellKernel<? super C, ? super S> kernel) {
  /** Checks that both parts are there. */
  public Pass {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(kernel, "kernel");
  }
}
