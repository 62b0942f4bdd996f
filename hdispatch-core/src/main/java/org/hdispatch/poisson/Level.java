package org.hdispatch.poisson;

import java.util.function.Consumer;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.KernelException;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;

/**
 * The cells of one level and the loop that passes over them. A level of one cell needs no worker:
 * the caller does it.
 */
final class Level {
  /** What a pass does; see {@link Kernels} and {@link Sweeps}. */
  enum Task {
    BEGIN,
    COLLECT,
    FORWARD,
    RESTRICT,
    BACKWARD,
    DIRECT,
    FINISH,
    EACH
  }

  final CellMap<GraphCell> cells;
  final Clusters clusters; // null at the coarser levels
  double sourceFactor = 1;

  private final TimeLoop loop; // null for one cell
  private final double[] scratch; // for one cell
  private Task task = Task.BEGIN;
  private Consumer<GraphCell> work; // of EACH
  private double alpha;
  private double beta;
  private int current; // of the two directions

  Level(CellMap<GraphCell> cells, Clusters clusters, Dispatcher dispatcher) {
    this.cells = cells;
    this.clusters = clusters;
    int nodes = 0;
    for (int n = 0; n < cells.size(); n++) {
      nodes = Math.max(nodes, cells.cellAt(n).nodes);
    }
    int most = nodes;
    if (cells.size() > 1) {
      scratch = null;
      loop =
          dispatcher.loop(
              Scheme.of(cells)
                  .scratch(() -> new double[most])
                  .pass("conjugate gradients", (cell, sums, tick) -> process(cell, sums))
                  .build());
    } else {
      scratch = new double[most];
      loop = null;
    }
  }

  /** Runs one pass. */
  void run(Task what) {
    task = what;
    if (loop != null) {
      loop.run(1);
    } else if (cells.size() == 1) {
      process(cells.cellAt(0), scratch);
    }
  }

  /**
   * Does something else to every cell, under the rules of a pass.
   *
   * @throws IllegalArgumentException if that did
   */
  void run(Consumer<GraphCell> ofCells) {
    work = ofCells;
    try {
      run(Task.EACH);
    } catch (KernelException e) {
      throw Passes.reason(e);
    } finally {
      work = null;
    }
  }

  /** Sweeps forward after a move by alpha along the direction, see {@link Sweeps#forward}. */
  void forward(double length) {
    alpha = length;
    run(Task.FORWARD);
  }

  /** Moves by alpha along the direction. */
  void finish(double length) {
    alpha = length;
    run(Task.FINISH);
  }

  /** Turns to the next direction, see {@link Kernels#direct}. */
  void direct(double shareOfPrevious) {
    beta = shareOfPrevious;
    run(Task.DIRECT);
    current = 1 - current;
  }

  private void process(GraphCell cell, double[] sums) {
    switch (task) {
      case BEGIN -> Kernels.begin(cell, sums, this);
      case COLLECT -> Sweeps.collect(cell);
      case FORWARD -> Sweeps.forward(cell, alpha, current);
      case RESTRICT -> Sweeps.restrict(cell);
      case BACKWARD -> Sweeps.backward(cell, sums);
      case DIRECT -> Kernels.direct(cell, sums, beta, current);
      case FINISH -> Kernels.finish(cell, alpha, current);
      case EACH -> work.accept(cell);
    }
  }

  /** One of the sums of the last pass, added up cell by cell in the order of the keys. */
  double sum(int which) {
    double sum = 0;
    for (int n = 0; n < cells.size(); n++) {
      sum += cells.cellAt(n).sums[which];
    }
    return sum;
  }

  long nodes() {
    long nodes = 0;
    for (int n = 0; n < cells.size(); n++) {
      nodes += cells.cellAt(n).nodes;
    }
    return nodes;
  }

  /** Bytes of all cells. */
  long bytes() {
    long bytes = 0;
    for (int n = 0; n < cells.size(); n++) {
      bytes += cells.cellAt(n).bytes();
    }
    return bytes;
  }
}
