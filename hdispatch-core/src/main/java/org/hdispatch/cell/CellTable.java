package org.hdispatch.cell;

import org.eclipse.collections.api.map.primitive.MutableLongObjectMap;
import org.eclipse.collections.impl.map.mutable.primitive.LongObjectHashMap;

/**
 * Hash map from keys to cells that allocates only when it grows. The library's map (as of 13.0)
 * makes itself anew when entries and marks of removed entries fill it; this one is cleared and
 * filled again before that happens, at most once in {@code room / 4} entries put. (Its two sentinel
 * keys, 0 and 1, belong to the farthest corner of the coordinates.)
 */
final class CellTable<C> {
  private MutableLongObjectMap<C> map;
  private int room;
  private int used; // entries, and no fewer marks than there are

  CellTable(int room) {
    this.room = room;
    map = new LongObjectHashMap<>(room);
  }

  C get(long key) {
    return map.get(key);
  }

  boolean contains(long key) {
    return map.containsKey(key);
  }

  /** Whether so many entries can be put before it has to be filled again. */
  boolean hasRoomFor(int entries) {
    return used + entries <= room;
  }

  /** Puts an entry for which there is room, and returns the cell that had this key before. */
  C put(long key, C cell) {
    used++;
    return map.put(key, cell);
  }

  void remove(long key) {
    map.removeKey(key);
  }

  /** Empties it, with room for so many entries and some more before the next time. */
  void clear(int entries) {
    if (entries > room - room / 4) {
      map = new LongObjectHashMap<>(2 * entries);
      room = 2 * entries;
    } else {
      map.clear();
    }
    used = 0;
  }
}
