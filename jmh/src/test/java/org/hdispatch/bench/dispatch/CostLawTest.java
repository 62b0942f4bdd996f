package org.hdispatch.bench.dispatch;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class CostLawTest {
  @ParameterizedTest
  @EnumSource
  void everyLawSpreadsTheSameWork(CostLaw law) {
    for (int cells : new int[] {64, 1000, 10_000}) {
      long sum = Arrays.stream(law.work(cells, 4000)).sum();
      long all = 4000L * cells;
      assertTrue(sum <= all && sum > all - cells, "sum=" + sum); // each is rounded down
    }
  }

  @Test
  void oneCellInTenIsHeavy() {
    long[] work = CostLaw.HEAVY_TAILED.work(10_000, 4000);
    long most = Arrays.stream(work).max().orElseThrow();
    long heavy = Arrays.stream(work).filter(each -> each == most).count();
    assertEquals(1000, heavy, 50);
    assertEquals(20, (double) most / Arrays.stream(work).min().orElseThrow(), 0.1);
  }

  @Test
  void quartersOfTheCellsDifferEightyfold() {
    assertArrayEquals(new long[] {80, 80, 320, 320, 4, 4, 80, 80}, CostLaw.CLUSTERED.work(8, 121));
  }
}
