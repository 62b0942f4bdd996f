package org.hdispatch.cell;

/**
 * What is thrown beside the way, apart from the hot classes: those have no string constants, which
 * would be made when they are compiled.
 */
final class Refusal {
  private Refusal() {}

  static IllegalArgumentException missing(long key) {
    return new IllegalArgumentException("cell must exist: key=" + CellKey.toString(key));
  }

  static IllegalArgumentException twice(long key) {
    return new IllegalArgumentException("cell keys must differ: key=" + CellKey.toString(key));
  }

  static IllegalArgumentException noKey(long key) {
    return new IllegalArgumentException("key must be one of CellKey.of: key=" + key);
  }

  static IllegalStateException fixed() {
    return new IllegalStateException("cells must not be fixed to be added or removed");
  }
}
