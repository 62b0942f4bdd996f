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
