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
 * the other in a young heap. The set of cells changes only in {@link #apply}, between steps; until
 * then look-ups from any thread are safe.
 *
 * @param <C> type of a cell
 */
public final class CellMap<C> {
  private final KeyOrder order;
  private final LongFunction<? extends C> newCell; // null: the cells are fixed
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
      long[] cellKeys,
      KeyOrder order,
      LongFunction<? extends C> firstCell,
      LongFunction<? extends C> newCell,
      ObjLongConsumer<? super C> renew) {
    Objects.requireNonNull(firstCell, "newCell");
    for (long key : cellKeys) {
      if (!CellKey.isKey(key)) {
        throw Refusal.noKey(key);
      }
    }
    this.order = order;
    this.newCell = newCell;
    this.renew = renew;
    keys = order.sorted(cellKeys);
    size = keys.length;
    cells = new Object[size];
    table = new CellTable<>(size);
    for (int index = 0; index < size; index++) {
      C cell = made(firstCell, keys[index]);
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
   * @param newCell makes the cell of a key, now and for every cell added later; then it sees the
   *     map as it was before the change
   * @throws IllegalArgumentException if a key comes twice or is none, or {@code newCell} returns
   *     null
   */
  public static <C> CellMap<C> of(long[] keys, KeyOrder order, LongFunction<? extends C> newCell) {
    return new CellMap<>(keys, order, newCell, newCell, null);
  }

  /**
   * As {@link #of(long[], KeyOrder, LongFunction)}, and keeps removed cells to use them again, from
   * the next change on: then adding and removing allocates nothing once everything has grown.
   *
   * @param renew turns a cell removed earlier into the new cell of a key
   */
  public static <C> CellMap<C> of(
      long[] keys,
      KeyOrder order,
      LongFunction<? extends C> newCell,
      ObjLongConsumer<? super C> renew) {
    Objects.requireNonNull(renew, "renew");
    return new CellMap<>(keys, order, newCell, newCell, renew);
  }

  /**
   * As {@link #of(long[], KeyOrder, LongFunction)}, for cells that never change: {@link #apply}
   * refuses, and {@code newCell} is not kept.
   */
  public static <C> CellMap<C> fixed(
      long[] keys, KeyOrder order, LongFunction<? extends C> newCell) {
    return new CellMap<>(keys, order, newCell, null, null);
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
   * <p>New cells are made in the order of hand-out, and that order is then the one that a new map
   * of these keys would have. If a cell cannot be made, the map stays as it was.
   *
   * @return whether any cell was added or removed
   * @throws IllegalArgumentException if {@code newCell} returns null
   * @throws IllegalStateException if the cells are {@link #fixed}
   */
  public boolean apply(CellChanges changes) {
    if (newCell == null) {
      throw Refusal.fixed();
    }
    try {
      changes.settle(order, this);
      if (changes.isEmpty()) {
        return false;
      }
      int newSize = size - changes.removedCount() + changes.addedCount();
      makeAdded(changes);
      makeRoom(changes, newSize);
      boolean refill = !table.hasRoomFor(changes.addedCount());
      if (refill) {
        table.clear(newSize);
      }
      takeOut(changes, refill);
      putIn(changes, refill);
    } finally {
      Arrays.fill(made, 0, Math.min(made.length, changes.addedCount()), null);
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
      made[n] = n < renewed ? renewed(spares[spareCount - 1 - n], key) : made(newCell, key);
    }
  }

  private static <C> C made(LongFunction<? extends C> newCell, long key) {
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

  /** Allocates what the change needs, before it begins. */
  private void makeRoom(CellChanges changes, int newSize) {
    if (newSize > keys.length) {
      keys = Arrays.copyOf(keys, Math.max(newSize, 2 * keys.length));
    }
    cells = withRoom(cells, newSize);
    if (renew != null) {
      spares = withRoom(spares, spareCount + changes.removedCount());
    }
  }

  private void takeOut(CellChanges changes, boolean refill) {
    int renewed = Math.min(changes.addedCount(), spareCount);
    spareCount -= renewed;
    Arrays.fill(spares, spareCount, spareCount + renewed, null);
    int kept = 0;
    int next = 0;
    for (int index = 0; index < size; index++) {
      if (next < changes.removedCount() && keys[index] == changes.removedAt(next)) {
        next++;
        if (!refill) {
          table.remove(keys[index]);
        }
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
  private void putIn(CellChanges changes, boolean refill) {
    int last = size - 1;
    int next = changes.addedCount() - 1;
    size += changes.addedCount();
    for (int index = size - 1; next >= 0; index--) {
      if (last >= 0 && order.compare(keys[last], changes.addedAt(next)) > 0) {
        keys[index] = keys[last];
        cells[index] = cells[last--];
      } else {
        keys[index] = changes.addedAt(next);
        cells[index] = made[next--];
        if (!refill) {
          table.put(keys[index], cellAt(index));
        }
      }
    }
    for (int index = 0; refill && index < size; index++) {
      table.put(keys[index], cellAt(index));
    }
  }

  private static Object[] withRoom(Object[] list, int count) {
    return count <= list.length ? list : Arrays.copyOf(list, Math.max(count, 2 * list.length));
  }
}
