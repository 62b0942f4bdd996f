package org.hdispatch.dispatch;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.hdispatch.cell.CellMap;

/**
 * A numerical method as the dispatcher sees it: cells, the scratch that a worker needs for one of
 * them, and the passes of a step.
 *
 * @param <C> type of a cell
 * @param <S> type of the scratch
 */
public interface Scheme<C, S> {
  /** The cells. Asked once, when a {@link TimeLoop} is made. */
  CellMap<C> cells();

  /** Makes the scratch of one worker; called by that worker, on its own thread. */
  S newScratch();

  /** The passes of a step, in order. Asked once, when a {@link TimeLoop} is made. */
  List<Pass<C, S>> passes();

  /** Runs on the caller's thread alone, before the first pass of each step. */
  default void beforeStep(Tick tick) {}

  /** Runs on the caller's thread alone, after the last pass of each step: sums, in key order. */
  default void afterStep(Tick tick) {}

  /** Starts a scheme over these cells. */
  static <C> Builder<C, Void> of(CellMap<C> cells) {
    return new Builder<>(cells, () -> null, List.of(), tick -> {}, tick -> {});
  }

  /**
   * Puts a scheme together from lambdas. Every method returns a new builder.
   *
   * @param <C> type of a cell
   * @param <S> type of the scratch
   */
  final class Builder<C, S> {
    private final CellMap<C> cells;
    private final Supplier<? extends S> newScratch;
    private final List<Pass<C, S>> passes;
    private final Consumer<Tick> before;
    private final Consumer<Tick> after;

    private Builder(
        CellMap<C> cells,
        Supplier<? extends S> newScratch,
        List<Pass<C, S>> passes,
        Consumer<Tick> before,
        Consumer<Tick> after) {
      this.cells = Objects.requireNonNull(cells, "cells");
      this.newScratch = Objects.requireNonNull(newScratch, "newScratch");
      this.passes = passes;
      this.before = Objects.requireNonNull(before, "before");
      this.after = Objects.requireNonNull(after, "after");
    }

    /**
     * Sets how a worker makes its scratch.
     *
     * @throws IllegalStateException if a pass has been added already
     */
    public <T> Builder<C, T> scratch(Supplier<? extends T> newScratch) {
      if (!passes.isEmpty()) {
        throw new IllegalStateException("scratch must be set before the first pass");
      }
      return new Builder<>(cells, newScratch, List.of(), before, after);
    }

    /** Adds a pass after those added before. */
    public Builder<C, S> pass(String name, CellKernel<? super C, ? super S> kernel) {
      List<Pass<C, S>> more = new ArrayList<>(passes);
      more.add(new Pass<>(name, kernel));
      return new Builder<>(cells, newScratch, List.copyOf(more), before, after);
    }

    /** Sets what the caller's thread does before each step. */
    public Builder<C, S> beforeStep(Consumer<Tick> action) {
      return new Builder<>(cells, newScratch, passes, action, after);
    }

    /** Sets what the caller's thread does after each step. */
    public Builder<C, S> afterStep(Consumer<Tick> action) {
      return new Builder<>(cells, newScratch, passes, before, action);
    }

    /**
     * The scheme.
     *
     * @throws IllegalStateException if it has no pass
     */
    public Scheme<C, S> build() {
      if (passes.isEmpty()) {
        throw new IllegalStateException("scheme must have at least one pass");
      }
      return new Scheme<>() {
        @Override
        public CellMap<C> cells() {
          return cells;
        }

        @Override
        public S newScratch() {
          return newScratch.get();
        }

        @Override
        public List<Pass<C, S>> passes() {
          return passes;
        }

        @Override
        public void beforeStep(Tick tick) {
          before.accept(tick);
        }

        @Override
        public void afterStep(Tick tick) {
          after.accept(tick);
        }
      };
    }
  }
}
