package org.hdispatch.dispatch;

import java.util.function.Supplier;

/** The scratch of every worker; as a task it makes them, each on its worker's thread. */
final class ScratchShelf<S> implements Dispatcher.Task {
  private final Supplier<S> newScratch;
  private final ScratchLifetime lifetime;
  private final Object[] scratch;
  private final long[] madeInStep;

  ScratchShelf(Supplier<S> newScratch, int workers, ScratchLifetime lifetime) {
    this.newScratch = newScratch;
    this.lifetime = lifetime;
    scratch = new Object[workers];
    madeInStep = new long[workers];
  }

  @SuppressWarnings("unchecked") // only scratch of type S is ever stored
  S scratch(int worker, Tick tick) {
    if (lifetime != ScratchLifetime.ENDURING) {
      renew(worker, tick);
    }
    return (S) scratch[worker];
  }

  private void renew(int worker, Tick tick) {
    if (lifetime == ScratchLifetime.PER_CELL || madeInStep[worker] != tick.step()) {
      madeInStep[worker] = tick.step();
      scratch[worker] = newScratch.get();
    }
  }

  @Override
  public void run(int index, int worker) {
    scratch[worker] = newScratch.get();
  }

  @Override
  public RuntimeException failure(int index, int worker, Throwable cause) {
    return Refusal.noScratch(worker, cause);
  }
}
