package org.hdispatch.app.console;

/** What the process says with its exit code. */
public enum ExitCode {
  /** The result is there. */
  DONE(0, "done; a rock that does not percolate is done: k = 0"),
  /** A fault of H-Dispatch itself. */
  FAULT(1, "a fault of H-Dispatch"),
  /** The arguments cannot be meant so. */
  USAGE(2, "bad arguments"),
  /** A file cannot be read or written. */
  FILE(3, "a file is missing, unreadable or wrong, or an output cannot be written"),
  /**
   * No steady state was reached, or a proof failed: what was computed is not what was asked for.
   */
  NOT_CONVERGED(4, "not converged, blew up, or a soak that did not pass"),
  /** The heap is too small. */
  TOO_LARGE(5, "does not fit into the heap"),
  /** The user ended it. */
  INTERRUPTED(130, "interrupted");

  private final int code;
  private final String meaning;

  ExitCode(int code, String meaning) {
    this.code = code;
    this.meaning = meaning;
  }

  /** The number that the process ends with. */
  public int code() {
    return code;
  }

  /** What it says, as the help puts it. */
  public String meaning() {
    return meaning;
  }
}
