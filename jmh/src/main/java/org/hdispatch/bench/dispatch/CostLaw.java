package org.hdispatch.bench.dispatch;

/** How the work of a step is spread over its cells. Integers only: no rounding, any language. */
public enum CostLaw {
  /** All alike. */
  UNIFORM {
    @Override
    long weight(int cell, int cells) {
      return 1;
    }
  },
  /** One cell in ten, here and there, costs twenty times the others. */
  HEAVY_TAILED {
    @Override
    long weight(int cell, int cells) {
      return ((cell * 2654435761L & 0xffffffffL) >>> 16) % 10 == 0 ? 20 : 1;
    }
  },
  /** Quarters of the order at 20 : 80 : 1 : 20, as where open and tight rock meet. */
  CLUSTERED {
    @Override
    long weight(int cell, int cells) {
      long quarter = 4L * cell / cells;
      return quarter == 1 ? 80 : quarter == 2 ? 1 : 20;
    }
  };

  /** Weight of one of {@code cells} cells. */
  abstract long weight(int cell, int cells);

  /** Work per cell: {@code meanWork} times its weight over the mean weight, rounded down. */
  long[] work(int cells, long meanWork) {
    long weights = 0;
    for (int cell = 0; cell < cells; cell++) {
      weights += weight(cell, cells);
    }
    long[] work = new long[cells];
    for (int cell = 0; cell < cells; cell++) {
      work[cell] = meanWork * weight(cell, cells) * cells / weights;
    }
    return work;
  }
}
