package org.hdispatch.app.study;

import java.util.Arrays;
import java.util.List;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Pass;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.Tick;
import org.hdispatch.gc.AllocationMeter;

/**
 * A scheme whose scratch is brought up to a given size by a working array, which is written through
 * once for each cell of each pass.
 *
 * <p>What the scratch of the scheme itself takes is counted when it is made; what it may grow by
 * while a cell is processed (that of SPH does) comes on top.
 */
final class PaddedScheme<C, S> implements Scheme<C, PaddedScheme.Padded<S>> {
  private final Scheme<C, S> inner;
  private final int length;

  /**
   * Measures the scratch of a scheme.
   *
   * @param bytes that it shall have
   * @throws IllegalArgumentException if it has more by itself
   */
  PaddedScheme(Scheme<C, S> inner, int bytes) {
    this.inner = inner;
    inner.newScratch(); // loads classes
    AllocationMeter meter = new AllocationMeter(Thread.currentThread().getId());
    long[] before = new long[1];
    long[] after = new long[1];
    meter.read(before);
    Object own = inner.newScratch();
    meter.read(after);
    long ownBytes = after[0] - before[0];
    if (ownBytes > bytes) {
      throw new IllegalArgumentException(
          "scratch must hold what the method needs: asked="
              + bytes
              + " B, needed="
              + ownBytes
              + " B, scratch="
              + own.getClass().getSimpleName());
    }
    length = (int) (bytes - ownBytes) / Double.BYTES;
  }

  /**
   * Scratch of a scheme with an array beside it.
   *
   * @param own of the scheme
   * @param array that brings it up to the size
   */
  record Padded<S>(S own, double[] array) {}

  @Override
  public CellMap<C> cells() {
    return inner.cells();
  }

  @Override
  public Padded<S> newScratch() {
    return new Padded<>(inner.newScratch(), new double[length]);
  }

  @Override
  public List<Pass<C, Padded<S>>> passes() {
    return inner.passes().stream().map(PaddedScheme::padded).toList();
  }

  private static <C, S> Pass<C, Padded<S>> padded(Pass<C, S> pass) {
    return new Pass<>(
        pass.name(),
        (cell, scratch, tick) -> {
          pass.kernel().process(cell, scratch.own, tick);
          Arrays.fill(scratch.array, tick.step());
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
