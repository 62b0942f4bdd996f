package org.hdispatch.dispatch;

import java.util.concurrent.CancellationException;
import org.hdispatch.cell.CellKey;

/**
 * What is thrown beside the way, in a class of its own. The first time that C2 compiles a method of
 * a class, the thread that asked for it makes all string constants of that class: a class that is
 * stepped through has none, so that not even that is allocated long after warm-up.
 */
final class Refusal {
  private Refusal() {}

  static IllegalStateException closed() {
    return new IllegalStateException("dispatcher must be open");
  }

  static IllegalStateException busy() {
    return new IllegalStateException("dispatcher must run one loop at a time");
  }

  static IllegalArgumentException negativeSteps(long steps) {
    return new IllegalArgumentException("steps must not be negative: steps=" + steps);
  }

  static IllegalStateException cellsChanged() {
    return new IllegalStateException(
        "cells must not change during a step other than through Tick.changes()");
  }

  static CancellationException closedMeanwhile() {
    return new CancellationException("dispatcher was closed");
  }

  static CancellationException cancelled() {
    return new CancellationException("run was cancelled");
  }

  static CancellationException interrupted() {
    return new CancellationException("run was interrupted");
  }

  static KernelException noScratch(int worker, Throwable cause) {
    return new KernelException("new scratch", CellKey.NONE, 0, worker, cause);
  }
}
