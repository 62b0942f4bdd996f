package org.hdispatch.cell;

import java.util.Arrays;
import java.util.Objects;
import java.util.function.LongFunction;
import java.util.function.ObjLongConsumer;

/**
 * The cells of a domain, owned by a hash map from primitive {@code long} keys, with the order in
 * which a dispatcher hands them out.
 *
 * <p>Cells are made in that order, so that cells handed out one after the other also lie one after
 * the other in a young heap. The set of cells changes only in {@link #apply}, between steps; in
 * between, look-ups from any thread are safe.
 *
 * @param <C> type of a cell
 */
public final class CellMap<C> {
  private final KeyOrder order;
  private final LongFunction<? extends C> newCell;
  private final ObjLongConsumer<? super C> renew; // null: removed cells are not kept
  private final CellTable<C> table;

  // By number of hand-out; the arrays may be longer than size.
  private long[] keys;
  private Object[] cells;
  private int size;

  private Object[] spares = new Object[0]; // removed cells, to be renewed
  private int spareCount;
  private Object[] made = new Object[0]; // those about to be added
  private long revision;

  private CellMap(
      long[] orderedKeys,
      KeyOrder order,
      LongFunction<? extends C> newCell,
      ObjLongConsumer<? super C> renew) {
    this.order = order;
    this.newCell = Objects.requireNonNull(newCell, "newCell");
    this.renew = renew;
    keys = orderedKeys;
    size = keys.length;
    cells = new Object[size];
    table = new CellTable<>(size);
    for (int index = 0; index < size; index++) {
      C cell = newCell(keys[index]);
      if (table.put(keys[index], cell) != null) {
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
   * @param newCell makes the cell of a key, now and for every cell added later
   * @throws IllegalArgumentException if a key comes twice or {@code newCell} returns null
   */
  public static <C> CellMap<C> of(long[] keys, KeyOrder order, LongFunction<? extends C> newCell) {
    return new CellMap<>(order.sorted(keys), order, newCell, null);
  }

  /**
   * As {@link #of(long[], KeyOrder, LongFunction)}, and keeps removed cells to use them again: then
   * adding and removing allocates nothing once everything has grown.
   *
   * @param renew turns a cell removed earlier into the new cell of a key
   */
  public static <C> CellMap<C> of(
      long[] keys,
      KeyOrder order,
      LongFunction<? extends C> newCell,
      ObjLongConsumer<? super C> renew) {
    Objects.requireNonNull(renew, "renew");
    return new CellMap<>(order.sorted(keys), order, newCell, renew);
  }

  /** The cell of a key, or null if there is none. */
  public C get(long key) {
    return table.get(key);
  }

  /** Whether a cell of this key exists. */
  public boolean contains(long key) {
    return table.contains(key);
  }

  /** Number of cells. */
  public int size() {
    return size;
  }

  /** Key of the cell handed out as number {@code index}; another one after a change. */
  public long keyAt(int index) {
    return keys[index];
  }

  /** The cell handed out as number {@code index}; another one after a change. */
  @SuppressWarnings("unchecked") // only cells of type C are ever stored
  public C cellAt(int index) {
    return (C) cells[index];
  }

  /**
   * How often the set of cells has changed. Whoever keeps cells, neighbours or numbers looks them
   * up anew when this has grown.
   */
  public long revision() {
    return revision;
  }

  /**
   * Adds and removes cells, and clears the changes. Not during a step: what kernels ask for through
   * {@code Tick.changes()} is applied by the loop.
   *
   * <p>New cells are made in key order, and the order of hand-out is the one that a new map of
   * these keys would have. If a cell cannot be made, the map stays as it was.
   *
   * @return whether any cell was added or removed
   * @throws IllegalArgumentException if {@code newCell} returns null
   */
  public boolean apply(CellChanges changes) {
    try {
      changes.settle(order, this);
      if (changes.isEmpty()) {
        return false;
      }
      makeAdded(changes);
      takeOut(changes);
      putIn(changes);
    } finally {
      changes.clear();
    }
    revision++;
    return true;
  }

  /** Makes the cells to be added; the map is not touched yet. */
  private void makeAdded(CellChanges changes) {
    int additions = changes.addedCount();
    made = withRoom(made, additions);
    int renewed = Math.min(additions, spareCount);
    for (int n = 0; n < additions; n++) {
      long key = changes.addedAt(n);
      made[n] = n < renewed ? renewed(spares[spareCount - 1 - n], key) : newCell(key);
    }
    spareCount -= renewed;
    Arrays.fill(spares, spareCount, spareCount + renewed, null);
  }

  private C newCell(long key) {
    C cell = newCell.apply(key);
    if (cell == null) {
      throw Refusal.missing(key);
    }
    return cell;
  }

  @SuppressWarnings("unchecked") // only cells of type C are ever stored
  private C renewed(Object spare, long key) {
    C cell = (C) spare;
    renew.accept(cell, key);
    return cell;
  }

  private void takeOut(CellChanges changes) {
    if (renew != null) {
      spares = withRoom(spares, spareCount + changes.removedCount());
    }
    int kept = 0;
    int next = 0;
    for (int index = 0; index < size; index++) {
      if (next < changes.removedCount() && keys[index] == changes.removedAt(next)) {
        next++;
        table.remove(keys[index]);
        if (renew != null) {
          spares[spareCount++] = cells[index];
        }
      } else {
        keys[kept] = keys[index];
        cells[kept++] = cells[index];
      }
    }
    Arrays.fill(cells, kept, size, null);
    size = kept;
  }

  /** Merges the new cells into the order, from its end. */
  private void putIn(CellChanges changes) {
    int last = size - 1;
    int next = changes.addedCount() - 1;
    size += changes.addedCount();
    if (size > keys.length) {
      keys = Arrays.copyOf(keys, Math.max(size, 2 * keys.length));
    }
    cells = withRoom(cells, size);
    for (int index = size - 1; next >= 0; index--) {
      if (last >= 0 && order.compare(keys[last], changes.addedAt(next)) > 0) {
        keys[index] = keys[last];
        cells[index] = cells[last--];
      } else {
        keys[index] = changes.addedAt(next);
        cells[index] = made[next];
        next--;
      }
    }
    if (table.hasRoomFor(changes.addedCount())) {
      for (int n = 0; n < changes.addedCount(); n++) {
        table.put(changes.addedAt(n), madeAt(n));
      }
    } else {
      table.clear(size);
      for (int index = 0; index < size; index++) {
        table.put(keys[index], cellAt(index));
      }
    }
    Arrays.fill(made, 0, changes.addedCount(), null);
  }

  @SuppressWarnings("unchecked") // only cells of type C are ever stored
  private C madeAt(int n) {
    return (C) made[n];
  }

  private static Object[] withRoom(Object[] list, int count) {
    return count <= list.length ? list : Arrays.copyOf(list, Math.max(count, 2 * list.length));
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
