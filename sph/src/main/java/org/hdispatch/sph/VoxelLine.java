package org.hdispatch.sph;

import org.hdispatch.cell.Ends;

/** One line of voxels, with what lies beyond its ends. */
final class VoxelLine {
  private final int extent;
  private final boolean periodic;
  private final int before; // places before the first voxel
  private final int[] heights;
  private final int[] apex; // of the parabolas of the envelope, from left to right
  private final double[] from; // where each begins

  /**
   * A line.
   *
   * @param solid whether a solid beyond an open end counts
   */
  VoxelLine(int extent, Ends ends, boolean solid) {
    this.extent = extent;
    periodic = ends == Ends.PERIODIC;
    before = periodic ? extent : solid ? 1 : 0;
    heights = new int[extent + 2 * before]; // beyond an open end: 0
    apex = new int[heights.length];
    from = new double[heights.length];
  }

  int extent() {
    return extent;
  }

  /** Lowers the squares of a line to those that come of its other places, too. */
  void lower(int[] squares, int start, int stride, int most) {
    for (int n = 0; n < extent; n++) {
      int height = squares[start + n * stride];
      heights[before + n] = height;
      if (periodic) {
        heights[n] = height;
        heights[2 * extent + n] = height;
      }
    }
    int last = envelope();
    int at = 0;
    for (int n = 0; n < extent; n++) {
      int place = before + n;
      while (at < last && from[at + 1] <= place) {
        at++;
      }
      int way = place - apex[at];
      squares[start + n * stride] = Math.min(most, heights[apex[at]] + way * way);
    }
  }

  /** Number of the last parabola of the envelope. */
  private int envelope() {
    int last = 0;
    apex[0] = 0;
    from[0] = Double.NEGATIVE_INFINITY;
    for (int place = 1; place < heights.length; place++) {
      double crossing = crossing(apex[last], place);
      while (crossing <= from[last]) {
        last--;
        crossing = crossing(apex[last], place);
      }
      last++;
      apex[last] = place;
      from[last] = crossing;
    }
    return last;
  }

  /** Where the parabola of a later place comes to lie below that of an earlier one. */
  private double crossing(int earlier, int later) {
    double rise = heights[later] + (double) later * later;
    rise -= heights[earlier] + (double) earlier * earlier;
    return rise / (2.0 * (later - earlier));
  }
}
