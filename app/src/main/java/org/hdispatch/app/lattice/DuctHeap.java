package org.hdispatch.app.lattice;

import org.hdispatch.app.console.Host;
import org.hdispatch.gc.GcWatch;
import org.hdispatch.lbm.duct.Duct;
import org.hdispatch.porous.block.HeapException;

/** How the heap is shared between a duct and the probe of the bandwidth. */
final class DuctHeap {
  /** Much more than any cache holds. */
  private static final long MOST_PROBE = 512L << 20;

  private static final long LEAST_PROBE = 8L << 20;

  private static final int REGIONS = 2048;
  private static final long LEAST_REGION = 1L << 20;
  private static final long MOST_REGION = 32L << 20;

  private DuctHeap() {}

  /**
   * Checks that a duct fits and returns how large the probe beside it may be, bytes.
   *
   * @throws HeapException if the duct does not fit
   */
  static long require(Host host, Duct duct) {
    double bytes = bytes(host, duct);
    host.requireHeap("a duct of " + duct.side() + "^3 nodes", bytes + LEAST_PROBE);
    double half = host.heapBeside(bytes) / 2;
    return (long) Math.max(LEAST_PROBE, Math.min(MOST_PROBE, half));
  }

  private static double bytes(Host host, Duct duct) {
    double bytes = duct.estimatedBytes();
    return GcWatch.collector().equals("G1")
        ? bytes * roundedUp(duct.arrayBytes(), Math.max(bytes, host.heapBytes()))
        : bytes;
  }

  /**
   * What an array takes on G1, over its own size: one of more than half a region gets whole regions
   * to itself. A heap has 2048 to 4096 regions, by its first and its largest size; the worse
   * counts.
   */
  static double roundedUp(double arrayBytes, double heapBytes) {
    double worst = 1;
    for (double heap : new double[] {heapBytes / 2, heapBytes}) {
      double region =
          Math.max(LEAST_REGION, Math.min(MOST_REGION, Long.highestOneBit((long) heap / REGIONS)));
      if (arrayBytes > region / 2) {
        worst = Math.max(worst, Math.ceil(arrayBytes / region) * region / arrayBytes);
      }
    }
    return worst;
  }
}
