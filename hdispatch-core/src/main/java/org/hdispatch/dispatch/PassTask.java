package org.hdispatch.dispatch;

import org.hdispatch.cell.CellMap;

/** A pass over all cells as a task each. */
final class PassTask<C, S> implements Task {
  private final String name;
  private final CellKernel<? super C, ? super S> kernel;
  private final CellMap<C> cells;
  private final ScratchShelf<S> shelf;
  private final Tick[] ticks; // by worker

  PassTask(Pass<C, S> pass, CellMap<C> cells, ScratchShelf<S> shelf, Tick[] ticks) {
    name = pass.name();
    kernel = pass.kernel();
    this.cells = cells;
    this.shelf = shelf;
    this.ticks = ticks;
  }

  String name() {
    return name;
  }

  /** The loop keeps what it needs in local variables: after a claim fields must be read anew. */
  @Override
  public void runFrom(int first, Worker worker) {
    CellKernel<? super C, ? super S> process = kernel;
    CellMap<C> map = cells;
    Tick tick = ticks[worker.id()];
    boolean renews = shelf.renews();
    S scratch = renews ? null : shelf.scratch(worker.id(), tick);
    for (int index = first; index >= 0; index = worker.next()) {
      if (renews) {
        scratch = shelf.scratch(worker.id(), tick);
      }
      process.process(map.cellAt(index), scratch, tick);
    }
  }

  /** Runs a single task. */
  void run(int index, int worker) {
    Tick tick = ticks[worker];
    kernel.process(cells.cellAt(index), shelf.scratch(worker, tick), tick);
  }

  @Override
  public RuntimeException failure(int index, int worker, Throwable cause) {
    return new KernelException(name, cells.keyAt(index), ticks[worker].step(), worker, cause);
  }
}
