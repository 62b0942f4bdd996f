package org.hdispatch.app.study;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicReference;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Pass;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.Tick;

/**
 * A scheme whose cells are processed by an executor of the JDK, a task for each cell, with scratch
 * from a {@link ThreadLocal}. To the dispatcher it is a single cell in which nothing happens: the
 * passes run before it, and the tick of that loop serves all tasks, so the cells must not change.
 */
final class ExecutorScheme<C, S> implements Scheme<Object, Void> {
  private final Scheme<C, S> inner;
  private final ExecutorService executor;
  private final ThreadLocal<S> scratch;
  private final List<Pass<C, S>> passes;
  private final CellMap<Object> nothing =
      CellMap.fixed(new long[] {CellKey.of(0, 0, 0)}, KeyOrder.ROW, key -> new Object());

  ExecutorScheme(Scheme<C, S> inner, ExecutorService executor) {
    this.inner = inner;
    this.executor = executor;
    scratch = ThreadLocal.withInitial(inner::newScratch);
    passes = inner.passes();
  }

  @Override
  public CellMap<Object> cells() {
    return nothing;
  }

  @Override
  public Void newScratch() {
    return null;
  }

  @Override
  public List<Pass<Object, Void>> passes() {
    return List.of(new Pass<>("nothing", (cell, none, tick) -> {}));
  }

  @Override
  public void beforeStep(Tick tick) {
    inner.beforeStep(tick);
    for (Pass<C, S> pass : passes) {
      run(pass, tick);
    }
    inner.afterStep(tick);
    if (!tick.changes().isEmpty()) {
      throw new IllegalStateException("cells must not change where tasks share a tick");
    }
  }

  private void run(Pass<C, S> pass, Tick tick) {
    CellMap<C> cells = inner.cells();
    CountDownLatch left = new CountDownLatch(cells.size());
    AtomicReference<Throwable> failure = new AtomicReference<>();
    for (int n = 0; n < cells.size(); n++) {
      C cell = cells.cellAt(n);
      executor.execute(
          () -> {
            try {
              pass.kernel().process(cell, scratch.get(), tick);
            } catch (Throwable e) { // the caller tells it
              failure.compareAndSet(null, e);
            } finally {
              left.countDown();
            }
          });
    }
    try {
      left.await(); // once: a wait for each task costs more than many a cell
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException();
    }
    if (failure.get() != null) {
      throw new IllegalStateException("pass '" + pass.name() + "' failed", failure.get());
    }
  }
}
