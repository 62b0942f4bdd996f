package org.hdispatch.poisson;

import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.KernelException;
import org.hdispatch.dispatch.Scheme;

/** Passes over cells outside of the iteration: what sets it up and what goes in and out of it. */
final class Passes {
  private Passes() {}

  /**
   * Runs one pass; a single cell needs no worker: the caller does it.
   *
   * @param scratch makes the scratch of a worker
   * @param work what is done to a cell; the ownership rule of {@code CellKernel} holds
   * @throws IllegalArgumentException what the work threw for a cell
   */
  static <C, S> void once(
      Dispatcher dispatcher, CellMap<C> cells, Supplier<S> scratch, BiConsumer<C, S> work) {
    if (cells.size() == 1) {
      work.accept(cells.cellAt(0), scratch.get());
    } else if (cells.size() > 1) {
      Scheme<C, S> scheme =
          Scheme.of(cells)
              .<S>scratch(scratch)
              .pass("set-up", (cell, own, tick) -> work.accept(cell, own))
              .build();
      try {
        dispatcher.loop(scheme).run(1);
      } catch (KernelException e) {
        throw reason(e);
      }
    }
  }

  /** What to throw when a kernel has failed: what it said of a value that the user gave, if so. */
  static RuntimeException reason(KernelException e) {
    return e.getCause() instanceof IllegalArgumentException refusal ? refusal : e;
  }
}
