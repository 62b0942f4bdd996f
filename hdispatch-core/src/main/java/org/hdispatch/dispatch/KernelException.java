package org.hdispatch.dispatch;

import org.hdispatch.cell.CellKey;

/**
 * A kernel threw: says in which pass, at which cell, in which step and on which worker. The cause
 * is what the kernel threw. Of several failures in one step the first is reported.
 */
public final class KernelException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** The pass that failed. */
  private final String pass;

  /** The cell that failed. */
  private final long cellKey;

  /** The step that failed. */
  private final long step;

  /** The worker that failed. */
  private final int worker;

  KernelException(String pass, long cellKey, long step, int worker, Throwable cause) {
    super(
        "pass '"
            + pass
            + "' failed at cell "
            + CellKey.toString(cellKey)
            + ", step "
            + step
            + ", worker "
            + worker
            + " <- "
            + reason(cause),
        cause);
    this.pass = pass;
    this.cellKey = cellKey;
    this.step = step;
    this.worker = worker;
  }

  private static String reason(Throwable cause) {
    return cause.getMessage() == null ? cause.getClass().getName() : cause.getMessage();
  }

  /** Name of the pass. */
  public String pass() {
    return pass;
  }

  /** Key of the cell. */
  public long cellKey() {
    return cellKey;
  }

  /** Number of the step. */
  public long step() {
    return step;
  }

  /** Number of the worker; 0 is the caller's thread. */
  public int worker() {
    return worker;
  }
}
