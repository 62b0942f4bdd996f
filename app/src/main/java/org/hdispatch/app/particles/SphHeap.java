package org.hdispatch.app.particles;

import java.util.Locale;
import org.hdispatch.app.console.Host;
import org.hdispatch.porous.block.HeapException;
import org.hdispatch.sph.SearchMode;

/** How much heap particles take. */
final class SphHeap {
  /** What particles come in, its growing counted. */
  private static final double GIVEN_BYTES = 100;

  /** Measured: 170 to 250 bytes, and those that the particles come in. */
  private static final double BYTES = 300 + GIVEN_BYTES;

  /** Of neighbours within 3 distances, in 3-D; measured: 150 to 250 bytes. */
  private static final double LIST_BYTES = 300;

  private static final double LIST_SUPPORT = 3;

  private SphHeap() {}

  /**
   * Checks that the particles could be given, before they are made.
   *
   * @param sites how many particles there are at most
   * @throws HeapException if not
   */
  static void requireSites(Host host, double sites) {
    host.requireHeap(String.format(Locale.ROOT, "%.0f particles", sites), sites * GIVEN_BYTES);
  }

  /**
   * Checks that particles fit.
   *
   * @param support radius, in distances of particles
   * @throws HeapException if they do not
   */
  static void require(
      Host host, SearchMode search, int dimensions, double particles, double support) {
    double lists =
        search == SearchMode.DOUBLE
            ? 0
            : LIST_BYTES * Math.pow(support, dimensions) / Math.pow(LIST_SUPPORT, 3);
    host.requireHeap(
        String.format(Locale.ROOT, "%.0f particles", particles), particles * (BYTES + lists));
  }
}
