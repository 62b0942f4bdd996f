package org.hdispatch.dispatch;

/** A pass as the workers see it: tasks 0 to n - 1. */
interface Task {
  /** Runs a task that the worker has claimed, and then those that {@link Worker#next} claims. */
  void runFrom(int first, Worker worker);

  /** The exception that says what failed. */
  RuntimeException failure(int index, int worker, Throwable cause);
}
