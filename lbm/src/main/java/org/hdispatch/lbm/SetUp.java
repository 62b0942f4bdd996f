package org.hdispatch.lbm;

import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;

/**
 * Passes over cells while a scheme is made: by the workers of a dispatcher, or by the caller alone.
 * The ownership rule of {@code CellKernel} holds, so who does it changes no bit.
 */
final class SetUp {
  private final Dispatcher dispatcher; // null: the caller alone

  private SetUp(Dispatcher dispatcher) {
    this.dispatcher = dispatcher;
  }

  /** By the caller alone. */
  static SetUp alone() {
    return new SetUp(null);
  }

  /** By the workers of a dispatcher. */
  static SetUp by(Dispatcher dispatcher) {
    return new SetUp(dispatcher);
  }

  /**
   * Runs one pass.
   *
   * @param scratch makes the scratch of a worker
   * @param work what is done to a cell
   */
  <C, S> void pass(String name, CellMap<C> cells, Supplier<S> scratch, BiConsumer<C, S> work) {
    if (dispatcher == null) {
      S own = scratch.get();
      for (int n = 0; n < cells.size(); n++) {
        work.accept(cells.cellAt(n), own);
      }
    } else {
      Scheme<C, S> scheme =
          Scheme.of(cells)
              .<S>scratch(scratch)
              .pass(name, (cell, own, tick) -> work.accept(cell, own))
              .build();
      dispatcher.loop(scheme).run(1);
    }
  }
}
