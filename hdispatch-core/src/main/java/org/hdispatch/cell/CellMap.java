package org.hdispatch.cell;

import java.util.function.LongFunction;
import org.eclipse.collections.api.map.primitive.MutableLongObjectMap;
import org.eclipse.collections.impl.map.mutable.primitive.LongObjectHashMap;

/**
 * The cells of a domain, owned by a hash map from primitive {@code long} keys, with the order in
 * which a dispatcher hands them out.
 *
 * <p>Cells are made in that order, so that cells handed out one after the other also lie one after
 * the other in a young heap. The set of cells is fixed once the map is made; look-ups from any
 * thread are safe.
 *
 * @param <C> type of a cell
 */
public final class CellMap<C> {
  private final MutableLongObjectMap<C> byKey;
  private final long[] keys;
  private final Object[] cells;

  private CellMap(long[] orderedKeys, LongFunction<? extends C> newCell) {
    keys = orderedKeys;
    cells = new Object[keys.length];
    byKey = new LongObjectHashMap<>(keys.length);
    for (int index = 0; index < keys.length; index++) {
      C cell = newCell.apply(keys[index]);
      if (cell == null) {
        throw Refusal.missing(keys[index]);
      }
      if (byKey.put(keys[index], cell) != null) {
        throw Refusal.twice(keys[index]);
      }
      cells[index] = cell;
    }
  }

  /**
   * Makes the cells of the given keys, in the given order.
   *
   * @param keys keys of the cells, each once, in any order
   * @param order order of allocation and hand-out
   * @param newCell makes the cell of a key
   * @throws IllegalArgumentException if a key comes twice or {@code newCell} returns null
   */
  public static <C> CellMap<C> of(long[] keys, KeyOrder order, LongFunction<? extends C> newCell) {
    return new CellMap<>(order.sorted(keys), newCell);
  }

  /** The cell of a key, or null if there is none. */
  public C get(long key) {
    return byKey.get(key);
  }

  /** Whether a cell of this key exists. */
  public boolean contains(long key) {
    return byKey.containsKey(key);
  }

  /** Number of cells. */
  public int size() {
    return keys.length;
  }

  /** Key of the cell handed out as number {@code index}. */
  public long keyAt(int index) {
    return keys[index];
  }

  /** The cell handed out as number {@code index}. */
  @SuppressWarnings("unchecked") // only cells of type C are ever stored
  public C cellAt(int index) {
    return (C) cells[index];
  }

  /** Apart, so that the hot class has no string constants to be made when it is compiled. */
  private static final class Refusal {
    static IllegalArgumentException missing(long key) {
      return new IllegalArgumentException("cell must exist: key=" + CellKey.toString(key));
    }

    static IllegalArgumentException twice(long key) {
      return new IllegalArgumentException("cell keys must differ: key=" + CellKey.toString(key));
    }
  }
}
