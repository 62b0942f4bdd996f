package org.hdispatch.dispatch;

/** A pass over all cells as a task each, the heaviest first. */
final class HeaviestFirstTask implements Task {
  private final PassTask<?, ?> pass;
  private final HeaviestFirst order;

  HeaviestFirstTask(PassTask<?, ?> pass, HeaviestFirst order) {
    this.pass = pass;
    this.order = order;
  }

  @Override
  public void runFrom(int first, Worker worker) {
    boolean measuring = order.measuring();
    for (int index = first; index >= 0; index = worker.next()) {
      int task = order.taskAt(index);
      long begin = measuring ? System.nanoTime() : 0;
      pass.run(task, worker.id());
      if (measuring) {
        order.measured(task, System.nanoTime() - begin);
      }
    }
  }

  @Override
  public RuntimeException failure(int index, int worker, Throwable cause) {
    return pass.failure(order.taskAt(index), worker, cause);
  }
}
