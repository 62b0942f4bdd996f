package org.hdispatch.dispatch;

/** A pass as the workers see it: tasks 0 to n - 1. */
interface Task {
  /** Runs one task. */
  void run(int index, int worker);

  /** The exception that says what failed. */
  RuntimeException failure(int index, int worker, Throwable cause);
}
