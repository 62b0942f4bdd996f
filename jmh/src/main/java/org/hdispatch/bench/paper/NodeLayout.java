package org.hdispatch.bench.paper;

import java.util.function.LongFunction;

/** How literally a dictionary of nodes is taken. */
enum NodeLayout {
  /** {@code HashMap<Long, Node>}, a node being two {@code double[]}. */
  DICTIONARY,
  /** The same, the keys not boxed. */
  PRIMITIVE_KEYS,
  /** {@code HashMap<Long, Node>}, a node being two {@code Double[]}. */
  BOXED_POPULATIONS;

  <V> Dictionary<V> dictionary(long[] keys, LongFunction<V> value) {
    return this == PRIMITIVE_KEYS
        ? new Dictionary.Primitive<>(keys, value)
        : new Dictionary.Boxed<>(keys, value);
  }

  Node node(int velocities) {
    return this == BOXED_POPULATIONS ? new Node.Boxed(velocities) : new Node.Plain(velocities);
  }
}
