package org.hdispatch.lbm.duct;

import java.util.Arrays;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;

/**
 * Measures what a memory-bound loop can hope for: {@code a[k] *= -1} over arrays that are together
 * much larger than the caches, handed out to the same workers as any other cells. Every number is
 * read and written once a sweep; both count (STREAM's "scale", in place, so that no line is fetched
 * only to be overwritten).
 */
public final class BandwidthProbe {
  /** Below half a region of the smallest heap on G1, and long beside what a hand-out costs. */
  private static final int NUMBERS = 1 << 15;

  private static final int BYTES = NUMBERS * Double.BYTES;
  private static final int WARM_UP_SWEEPS = 3;

  private final Scheme<double[], Void> scheme;
  private final double factor = -1; // a field, so that the compiler does not know it

  /**
   * Allocates the arrays.
   *
   * @param bytes of all arrays together; at least one is made
   */
  public BandwidthProbe(long bytes) {
    int count = (int) Math.max(1, Math.min(bytes / BYTES, CellKey.MAX));
    long[] keys = new long[count];
    Arrays.setAll(keys, n -> CellKey.of(n, 0, 0));
    CellMap<double[]> arrays = CellMap.fixed(keys, KeyOrder.ROW, key -> ones());
    scheme = Scheme.of(arrays).pass("scale", (array, none, tick) -> scale(array, factor)).build();
  }

  private static double[] ones() {
    double[] array = new double[NUMBERS];
    Arrays.fill(array, 1);
    return array;
  }

  private static void scale(double[] array, double factor) {
    for (int k = 0; k < array.length; k++) {
      array[k] *= factor;
    }
  }

  /** Bytes of all arrays together. */
  public long bytes() {
    return (long) scheme.cells().size() * BYTES;
  }

  /** The sweeps of a dispatcher's workers, warmed up. */
  public Sweeps on(Dispatcher dispatcher) {
    Sweeps sweeps = new Sweeps(dispatcher.loop(scheme), bytes());
    sweeps.loop.run(WARM_UP_SWEEPS);
    return sweeps;
  }

  /** Sweeps by the workers of one dispatcher. */
  public static final class Sweeps {
    private final TimeLoop loop;
    private final long bytes;

    private Sweeps(TimeLoop loop, long bytes) {
      this.loop = loop;
      this.bytes = bytes;
    }

    /** Sweeps once: bytes read plus bytes written, 10^9 a second. */
    public double gigabytesPerSecond() {
      long begin = System.nanoTime();
      loop.run(1);
      return 2.0 * bytes / (System.nanoTime() - begin);
    }
  }
}
