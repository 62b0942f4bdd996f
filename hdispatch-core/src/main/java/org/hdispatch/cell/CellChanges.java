package org.hdispatch.cell;

import java.util.Arrays;

/**
 * Cells to be added to a {@link CellMap} and cells to be removed from it, as keys.
 *
 * <p>The order in which they are asked for makes no difference, nor does asking twice: a key asked
 * for both ways is added. Asking allocates nothing once the lists have grown. For one thread.
 */
public final class CellChanges {
  private static final int FIRST_LENGTH = 16;

  private long[] added = new long[FIRST_LENGTH];
  private long[] removed = new long[FIRST_LENGTH];
  private int addedCount;
  private int removedCount;

  /** No changes. */
  public CellChanges() {}

  /**
   * Asks for a cell to be there. {@link CellKey#NONE} and the key of a cell that exists already ask
   * for nothing.
   *
   * @throws IllegalArgumentException if no cell can have this key
   */
  public void add(long key) {
    if (isCell(key)) {
      added = withRoom(added, addedCount + 1);
      added[addedCount++] = key;
    }
  }

  /**
   * Asks for a cell to go. {@link CellKey#NONE} and a key without a cell ask for nothing.
   *
   * @throws IllegalArgumentException if no cell can have this key
   */
  public void remove(long key) {
    if (isCell(key)) {
      removed = withRoom(removed, removedCount + 1);
      removed[removedCount++] = key;
    }
  }

  private static boolean isCell(long key) {
    if (CellKey.isKey(key)) {
      return true;
    }
    if (key != CellKey.NONE) {
      throw Refusal.noKey(key);
    }
    return false;
  }

  /**
   * Takes over what others ask for, who ask for nothing then. They get as much room as this has, so
   * that it makes no difference to the garbage which of them asks for how much.
   */
  public void takeAll(CellChanges others) {
    added = withRoom(added, addedCount + others.addedCount);
    removed = withRoom(removed, removedCount + others.removedCount);
    System.arraycopy(others.added, 0, added, addedCount, others.addedCount);
    System.arraycopy(others.removed, 0, removed, removedCount, others.removedCount);
    addedCount += others.addedCount;
    removedCount += others.removedCount;
    others.clear();
    others.added = withRoom(others.added, added.length);
    others.removed = withRoom(others.removed, removed.length);
  }

  /** Whether nothing is asked for. */
  public boolean isEmpty() {
    return addedCount == 0 && removedCount == 0;
  }

  /** Forgets everything that was asked for. */
  public void clear() {
    addedCount = 0;
    removedCount = 0;
  }

  /**
   * Brings both lists into order and leaves in them, each once, what makes a difference: additions
   * of missing cells, and removals of cells that exist and that nobody wants added.
   */
  void settle(KeyOrder order, CellMap<?> cells) {
    addedCount = order.sortDistinct(added, addedCount);
    removedCount = order.sortDistinct(removed, removedCount);
    int removals = 0;
    int a = 0;
    for (int r = 0; r < removedCount; r++) {
      long key = removed[r];
      while (a < addedCount && order.compare(added[a], key) < 0) {
        a++;
      }
      boolean wanted = a < addedCount && added[a] == key;
      if (!wanted && cells.contains(key)) {
        removed[removals++] = key;
      }
    }
    removedCount = removals;
    int additions = 0;
    for (a = 0; a < addedCount; a++) {
      if (!cells.contains(added[a])) {
        added[additions++] = added[a];
      }
    }
    addedCount = additions;
  }

  int addedCount() {
    return addedCount;
  }

  long addedAt(int index) {
    return added[index];
  }

  int removedCount() {
    return removedCount;
  }

  long removedAt(int index) {
    return removed[index];
  }

  private static long[] withRoom(long[] list, int count) {
    return count <= list.length ? list : Arrays.copyOf(list, Math.max(count, 2 * list.length));
  }
}
