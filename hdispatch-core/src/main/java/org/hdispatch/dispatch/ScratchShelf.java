package org.hdispatch.dispatch;

import java.util.function.Supplier;

/** The scratch of every worker; as a task it makes them, each on its worker's thread. */
final class ScratchShelf<S> implements Task {
  /** Slots between those of two workers, so that no cache line holds both: 32 references. */
  private static final int STRIDE = 32;

  private final Supplier<S> newScratch;
  private final ScratchLifetime lifetime;
  private final Object[] scratch;
  private final long[] madeInStep; // what was made with the loop serves step 0

  ScratchShelf(Supplier<S> newScratch, int workers, ScratchLifetime lifetime) {
    this.newScratch = newScratch;
    this.lifetime = lifetime;
    scratch = new Object[workers * STRIDE];
    madeInStep = new long[workers * STRIDE];
  }

  /** Whether a worker's scratch may be another one for the next cell. */
  boolean renews() {
    return lifetime != ScratchLifetime.ENDURING;
  }

  /** The scratch of a worker, made anew if its time is over. */
  @SuppressWarnings("unchecked") // only scratch of type S is ever stored
  S scratch(int worker, Tick tick) {
    if (lifetime == ScratchLifetime.PER_CELL
        || lifetime == ScratchLifetime.PER_STEP && madeInStep[worker * STRIDE] != tick.step()) {
      scratch[worker * STRIDE] = newScratch.get();
      madeInStep[worker * STRIDE] = tick.step();
    }
    return (S) scratch[worker * STRIDE];
  }

  @Override
  public void runFrom(int first, Worker worker) {
    for (int index = first; index >= 0; index = worker.next()) {
      scratch[worker.id() * STRIDE] = newScratch.get();
    }
  }

  @Override
  public RuntimeException failure(int index, int worker, Throwable cause) {
    return Refusal.noScratch(worker, cause);
  }
}
