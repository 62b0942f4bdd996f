package org.hdispatch.bench.paper;

import java.util.function.IntConsumer;

/** A flow under way. */
record Stepper(IntConsumer steps, Runnable end) implements AutoCloseable {
  void run(int count) {
    steps.accept(count);
  }

  @Override
  public void close() {
    end.run();
  }
}
