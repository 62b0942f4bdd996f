package org.hdispatch.app.console;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import org.junit.jupiter.api.Test;

class ThreadOptionsTest {
  @Test
  void threadsAreAllOfAFewAndSomeOfMany() {
    assertArrayEquals(new int[] {1}, ThreadOptions.upTo(1));
    assertArrayEquals(new int[] {1, 2, 3, 4}, ThreadOptions.upTo(4));
    assertArrayEquals(new int[] {1, 2, 3, 4, 6, 8, 12, 16, 24}, ThreadOptions.upTo(24));
    assertArrayEquals(new int[] {1, 2, 3, 4, 5}, ThreadOptions.upTo(5));
  }
}
