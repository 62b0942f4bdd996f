package org.hdispatch.bench.dispatch;

/** In which order the cells of a {@link GatherDomain} are handed out. */
public enum GatherOrder {
  /** Row by row, and allocated so. */
  ROW,
  /** Along the Morton curve, and allocated so. */
  MORTON,
  /** Shuffled, always alike, but allocated row by row. */
  RANDOM
}
