package org.hdispatch.cell;

import java.util.Arrays;

/**
 * The order in which cells are allocated and handed out. It never changes a result, only which
 * cells lie near each other in memory and in time.
 */
public enum KeyOrder {
  /** Row by row: i fastest, then j, then k. */
  ROW {
    @Override
    long code(long key) {
      return key;
    }

    @Override
    long key(long code) {
      return code;
    }
  },
  /** Along the Morton (Z-order) curve: neighbours in space are mostly neighbours in the order. */
  MORTON {
    @Override
    long code(long key) {
      long mask = (1L << CellKey.BITS) - 1;
      return spread(key & mask)
          | spread(key >>> CellKey.BITS & mask) << 1
          | spread(key >>> 2 * CellKey.BITS & mask) << 2;
    }

    @Override
    long key(long code) {
      return gather(code)
          | gather(code >>> 1) << CellKey.BITS
          | gather(code >>> 2) << 2 * CellKey.BITS;
    }
  };

  /** Rank of a key on the curve; increasing codes are the order. */
  abstract long code(long key);

  /** Inverse of {@link #code}. */
  abstract long key(long code);

  /** A copy of the keys in this order. */
  public long[] sorted(long[] keys) {
    long[] codes = new long[keys.length];
    for (int n = 0; n < keys.length; n++) {
      codes[n] = code(keys[n]);
    }
    Arrays.sort(codes);
    for (int n = 0; n < codes.length; n++) {
      codes[n] = key(codes[n]);
    }
    return codes;
  }

  /**
   * Less than, equal to or greater than 0 as the first key comes before, with or after the other.
   */
  int compare(long key, long other) {
    return Long.compare(code(key), code(other));
  }

  /**
   * Brings the first {@code count} keys into this order, each once.
   *
   * @return how many are left
   */
  int sortDistinct(long[] keys, int count) {
    for (int n = 0; n < count; n++) {
      keys[n] = code(keys[n]);
    }
    heapSort(keys, count);
    int distinct = 0;
    for (int n = 0; n < count; n++) {
      long key = key(keys[n]);
      if (distinct == 0 || keys[distinct - 1] != key) {
        keys[distinct++] = key;
      }
    }
    return distinct;
  }

  /** Sorts in place. {@code Arrays.sort} does too, but allocates where it finds sorted runs. */
  private static void heapSort(long[] values, int count) {
    for (int root = count / 2 - 1; root >= 0; root--) {
      siftDown(values, root, count);
    }
    for (int end = count - 1; end > 0; end--) {
      long last = values[end];
      values[end] = values[0];
      values[0] = last;
      siftDown(values, 0, end);
    }
  }

  private static void siftDown(long[] values, int start, int count) {
    long value = values[start];
    int hole = start;
    for (int child = 2 * hole + 1; child < count; child = 2 * hole + 1) {
      if (child + 1 < count && values[child + 1] > values[child]) {
        child++;
      }
      if (values[child] <= value) {
        break;
      }
      values[hole] = values[child];
      hole = child;
    }
    values[hole] = value;
  }

  /** Moves bit b of a 21-bit number to bit 3 b. */
  private static long spread(long bits) {
    long x = bits;
    x = (x | x << 32) & 0x1f00000000ffffL;
    x = (x | x << 16) & 0x1f0000ff0000ffL;
    x = (x | x << 8) & 0x100f00f00f00f00fL;
    x = (x | x << 4) & 0x10c30c30c30c30c3L;
    x = (x | x << 2) & 0x1249249249249249L;
    return x;
  }

  /** Moves bit 3 b to bit b, the inverse of {@link #spread}. */
  private static long gather(long bits) {
    long x = bits & 0x1249249249249249L;
    x = (x | x >>> 2) & 0x10c30c30c30c30c3L;
    x = (x | x >>> 4) & 0x100f00f00f00f00fL;
    x = (x | x >>> 8) & 0x1f0000ff0000ffL;
    x = (x | x >>> 16) & 0x1f00000000ffffL;
    x = (x | x >>> 32) & 0x1fffffL;
    return x;
  }
}
