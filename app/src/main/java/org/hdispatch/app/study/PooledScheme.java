package org.hdispatch.app.study;

import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Pass;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.Tick;

/** A scheme whose scratch is borrowed from a pool of objects for each cell, and given back. */
final class PooledScheme<C, S> implements Scheme<C, Queue<S>> {
  private final Scheme<C, S> inner;
  private final Queue<S> pool = new ConcurrentLinkedQueue<>();

  PooledScheme(Scheme<C, S> inner) {
    this.inner = inner;
  }

  @Override
  public CellMap<C> cells() {
    return inner.cells();
  }

  /** The pool: workers have no scratch of their own. */
  @Override
  public Queue<S> newScratch() {
    return pool;
  }

  @Override
  public List<Pass<C, Queue<S>>> passes() {
    return inner.passes().stream().map(this::borrowing).toList();
  }

  private Pass<C, Queue<S>> borrowing(Pass<C, S> pass) {
    return new Pass<>(
        pass.name(),
        (cell, queue, tick) -> {
          S borrowed = queue.poll();
          S scratch = borrowed == null ? inner.newScratch() : borrowed;
          pass.kernel().process(cell, scratch, tick);
          queue.add(scratch);
        });
  }

  @Override
  public void beforeStep(Tick tick) {
    inner.beforeStep(tick);
  }

  @Override
  public void afterStep(Tick tick) {
    inner.afterStep(tick);
  }
}
