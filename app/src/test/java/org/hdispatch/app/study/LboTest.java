package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class LboTest {
  private static final GcRow ENDURING =
      GcRows.row(GcRows.run(Collector.SERIAL, ScratchPolicy.ENDURING, 6), 2.0, 0.1);
  private static final GcRow PER_CELL =
      GcRows.row(GcRows.run(Collector.G1, ScratchPolicy.PER_CELL, 2), 2.5, 1.5);
  private static final GcRow DIED =
      GcRows.died(GcRows.run(Collector.EPSILON, ScratchPolicy.PER_CELL, 2), "out of memory");
  private static final Lbo LBO = Lbo.of(List.of(PER_CELL, ENDURING, DIED));

  @Test
  void baselineIsTheLeastTimeApartFromTheCollector() {
    assertEquals(0.02, LBO.baselineSeconds(PER_CELL.of()).getAsDouble());
    assertEquals(0.02, LBO.baselineSeconds(DIED.of()).getAsDouble());
  }

  @Test
  void costCountsTheCollectorAndIsOverTheBaseline() {
    assertEquals(2.0, LBO.cost(PER_CELL).getAsDouble());
    assertEquals(1.05, LBO.cost(ENDURING).getAsDouble(), 1e-15); // one rounding of 2.0 + 0.1
  }

  @Test
  void runWithoutFiguresHasNoCost() {
    assertTrue(LBO.cost(DIED).isEmpty());
    assertTrue(Lbo.of(List.of(DIED)).baselineSeconds(DIED.of()).isEmpty());
  }

  @Test
  void anotherScratchSizeAndAnotherJvmHaveBaselinesOfTheirOwn() {
    GcCase of = ENDURING.of();
    GcCase small =
        new GcCase(of.java(), of.collector(), of.policy(), of.workload(), 1 << 12, of.heapFactor());
    GcCase newer =
        new GcCase("25.0.3", of.collector(), of.policy(), of.workload(), 1 << 16, of.heapFactor());
    assertTrue(LBO.baselineSeconds(small).isEmpty());
    Lbo both = Lbo.of(List.of(ENDURING, GcRows.row(newer, 1.0, 0), GcRows.row(small, 0.5, 0)));
    assertEquals(0.02, both.baselineSeconds(of).getAsDouble());
    assertEquals(0.01, both.baselineSeconds(newer).getAsDouble());
    assertEquals(0.005, both.baselineSeconds(small).getAsDouble());
  }
}
