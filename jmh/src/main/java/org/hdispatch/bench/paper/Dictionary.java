package org.hdispatch.bench.paper;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.LongFunction;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.KeyOrder;

/** A hash map by numbers. A benchmark loads one of the two, so that its calls can be inlined. */
interface Dictionary<V> {
  /** The value of a key, or null. */
  V get(long key);

  /** Visits all values. */
  void forEach(Visitor<? super V> visitor);

  /** Receives a key and its value. */
  interface Visitor<V> {
    void visit(long key, V value);
  }

  /** Java's own map, the keys boxed. */
  final class Boxed<V> implements Dictionary<V> {
    private final Map<Long, V> map = new HashMap<>();

    Boxed(long[] keys, LongFunction<V> value) {
      for (long key : keys) {
        map.put(key, value.apply(key));
      }
    }

    @Override
    public V get(long key) {
      return map.get(key);
    }

    @Override
    public void forEach(Visitor<? super V> visitor) {
      for (Map.Entry<Long, V> entry : map.entrySet()) {
        visitor.visit(entry.getKey(), entry.getValue());
      }
    }
  }

  /** A map whose keys are plain numbers, as in .NET: that of this library's cells. */
  final class Primitive<V> implements Dictionary<V> {
    private final CellMap<V> map;

    Primitive(long[] keys, LongFunction<V> value) {
      map = CellMap.fixed(Arrays.copyOf(keys, keys.length), KeyOrder.ROW, value);
    }

    @Override
    public V get(long key) {
      return map.get(key);
    }

    @Override
    public void forEach(Visitor<? super V> visitor) {
      for (int index = 0; index < map.size(); index++) {
        visitor.visit(map.keyAt(index), map.cellAt(index));
      }
    }
  }
}
