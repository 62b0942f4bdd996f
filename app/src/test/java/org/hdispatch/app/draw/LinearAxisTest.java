package org.hdispatch.app.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class LinearAxisTest {
  @Test
  void ticksAreEasyToRead() {
    assertEquals(50, LinearAxis.tickDistance(160));
    assertEquals(20, LinearAxis.tickDistance(100));
    assertEquals(0.2, LinearAxis.tickDistance(0.9), 1e-12);
    assertEquals(1, LinearAxis.tickDistance(5));
  }
}
