package org.hdispatch.bench.lbm;

import org.hdispatch.lbm.BundleSize;

/** Reads bundle sizes from benchmark parameters. */
public final class BundleSizes {
  private BundleSizes() {}

  /**
   * The size that a text names.
   *
   * @param text edge of a cube, or {@code nx}x{@code ny}x{@code nz}
   * @throws IllegalArgumentException if it is neither
   */
  public static BundleSize parse(String text) {
    String[] edges = text.split("x", -1);
    if (edges.length == 1) {
      return BundleSize.cube(Integer.parseInt(text));
    }
    if (edges.length == 3) {
      return new BundleSize(
          Integer.parseInt(edges[0]), Integer.parseInt(edges[1]), Integer.parseInt(edges[2]));
    }
    throw new IllegalArgumentException("bundle must be N or NXxNYxNZ: bundle=" + text);
  }
}
