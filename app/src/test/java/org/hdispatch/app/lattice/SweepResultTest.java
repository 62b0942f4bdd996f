package org.hdispatch.app.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.dispatch.LoopStats;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.lbm.duct.Duct;
import org.hdispatch.lbm.duct.DuctFigures;
import org.hdispatch.lbm.duct.DuctRun;
import org.hdispatch.lbm.duct.Spread;
import org.junit.jupiter.api.Test;

class SweepResultTest {
  private static final DuctSettings SETTINGS =
      new DuctSettings(VelocitySet.D3Q15, Streaming.IN_PLACE, Storage.DOUBLE, KernelForm.SCALAR);

  private static SweepResult.Point point(
      int side, String label, int threads, double mlups, double bandwidth, double k) {
    boolean control = label.equals(SweepResult.CONTROL);
    Duct duct = SETTINGS.duct(side, BundleShape.parse(control ? "all" : label));
    double seconds = duct.nodes() / mlups * 1e-6;
    return new SweepResult.Point(
        new DuctSweep.Case(duct, label, control, threads),
        new DuctFigures(
            duct,
            threads,
            new DuctRun(24, 48, DuctRun.Ending.MEASURED),
            new Spread(seconds, seconds, seconds),
            new Spread(bandwidth, bandwidth, bandwidth),
            1,
            0,
            new LoopStats(0, 0, List.of()),
            72,
            k));
  }

  static SweepResult.Point point(
      int side, String label, int threads, double mlups, double bandwidth) {
    return point(side, label, threads, mlups, bandwidth, 0.01);
  }

  private static SweepResult sweep() {
    return new SweepResult(
        SETTINGS,
        1 << 20,
        List.of(
            point(20, "10", 1, 50, 28),
            point(20, "10", 2, 90, 50),
            point(20, "all,8,8", 1, 60, 30),
            point(20, "all,8,8", 2, 100, 54),
            point(20, SweepResult.CONTROL, 1, 70, 32),
            point(20, SweepResult.CONTROL, 2, 120, 58),
            point(30, "10", 2, 110, 54),
            point(30, "all,8,8", 2, 99, 54)));
  }

  @Test
  void recommendsTheFastestBundleOfTheFirstSizeWithMostThreads() {
    SweepResult.Point best = sweep().recommended().orElseThrow();
    assertEquals("all,8,8", best.label()); // not the control
    assertEquals(20, best.side());
    assertEquals(2, best.threads());
    assertEquals("10", sweep().best(30).orElseThrow().label());
  }

  @Test
  void speedUpIsAgainstTheSameBundleOnOneThread() {
    SweepResult sweep = sweep();
    SweepResult.Point best = sweep.recommended().orElseThrow();
    assertEquals(100.0 / 60, sweep.speedUp(best).getAsDouble(), 1e-12);
    assertEquals(100.0 / 120, sweep.efficiency(best).getAsDouble(), 1e-12);
    assertEquals(OptionalDouble.empty(), sweep.speedUp(sweep.best(30).orElseThrow()));
  }

  @Test
  void bandwidthSpeedUpIsOverAllRuns() {
    SweepResult sweep = sweep();
    // medians of 28, 30, 32 and of 50, 54, 54, 54, 58
    assertEquals(54.0 / 30, sweep.bandwidthSpeedUp(2).getAsDouble(), 1e-12);
  }

  @Test
  void idealIsWhatThreadsOrBandwidthAllowWhicheverIsLess() {
    SweepResult.Point free = point(20, "10", 2, 90, 50); // 208 MLUPS by the bandwidth
    SweepResult.Point bound = point(20, "20", 2, 100, 26.4); // 110 MLUPS by the bandwidth
    SweepResult sweep =
        new SweepResult(
            SETTINGS,
            1,
            List.of(point(20, "10", 1, 50, 28), free, point(20, "20", 1, 60, 28), bound));
    assertEquals(100, sweep.idealMlups(free).getAsDouble(), 1e-12);
    assertEquals(0.9, sweep.idealFraction(free).getAsDouble(), 1e-12);
    assertEquals(sweep.efficiency(free).getAsDouble(), 0.9, 1e-12);
    assertEquals(110, sweep.idealMlups(bound).getAsDouble(), 1e-12);
    assertEquals(100.0 / 110, sweep.idealFraction(bound).getAsDouble(), 1e-12);
    assertEquals(100.0 / 110, bound.figures().bandwidthFraction(), 1e-12);
    SweepResult.Point alone = point(30, "10", 2, 110, 54);
    SweepResult without = new SweepResult(SETTINGS, 1, List.of(alone));
    assertEquals(OptionalDouble.empty(), without.idealMlups(alone));
    assertEquals(OptionalDouble.empty(), without.idealFraction(alone));
  }

  @Test
  void smallDuctsRecommendButStoreNothing() {
    assertTrue(sweep().recommended().isPresent());
    assertEquals(Optional.empty(), sweep().storable());
    SweepResult.Point large = point(100, "10", 2, 110, 54);
    SweepResult sweep = new SweepResult(SETTINGS, 1, List.of(large));
    assertEquals(Optional.of(large), sweep.storable());
  }

  @Test
  void smallProbeIsSaidToMeasureACache() {
    assertTrue(SweepReport.text(sweep(), "no").contains("over 1 MiB: a CACHE may hold that"));
    SweepResult large = new SweepResult(SETTINGS, 512 << 20, sweep().points());
    assertFalse(SweepReport.text(large, "no").contains("CACHE"));
  }

  @Test
  void plotHasALegendForThreadsSizesAndTheControl() {
    String both = SweepPlot.of(sweep());
    for (String words :
        List.of(
            "1 thread<",
            "2 threads<",
            "20\u00b3 nodes<",
            "30\u00b3 nodes<",
            "one block a thread<")) {
      assertTrue(both.contains(">" + words), () -> words + " <- " + both);
    }
    assertTrue(both.contains(">speed, MLUPS<") && both.contains(">efficiency, % of the threads<"));
    SweepResult alone = new SweepResult(SETTINGS, 1, List.of(point(20, "10", 1, 50, 28)));
    assertFalse(SweepPlot.of(alone).contains("efficiency, %"), "one thread has none");
  }

  @Test
  void runsThatDisagreeAboutTheFlowAreAFault() {
    List<SweepResult.Point> points =
        List.of(point(20, "10", 1, 50, 28, 0.01), point(20, "10", 2, 50, 28, 0.01 * (1 + 1e-8)));
    assertThrows(IllegalStateException.class, () -> new SweepResult(SETTINGS, 1, points));
    List<SweepResult.Point> nothing = List.of(point(20, "10", 1, 50, 28, Double.NaN));
    assertThrows(IllegalStateException.class, () -> new SweepResult(SETTINGS, 1, nothing));
  }

  @Test
  void ofSeveralRoundsTheOneWithTheMostUsualBandwidthCounts() {
    DuctFigures fast = point(20, "10", 2, 120, 80).figures();
    DuctFigures usual = point(20, "10", 2, 110, 51).figures();
    DuctFigures slow = point(20, "10", 2, 60, 30).figures();
    assertEquals(usual, DuctSweep.nearest(List.of(fast, usual, slow), 53));
  }

  @Test
  void bandwidthThatVariesIsSaid() {
    assertFalse(SweepReport.text(sweep(), "no").contains("DISTURBED"));
    SweepResult disturbed =
        new SweepResult(
            SETTINGS, 1, List.of(point(20, "10", 2, 90, 50), point(20, "20", 2, 120, 80)));
    String text = SweepReport.text(disturbed, "no");
    assertTrue(text.contains("with 2 threads was between 50.0 and 80.0 GB/s"), text);
  }

  @Test
  void textSaysWhatFollows() {
    String text = SweepReport.text(sweep(), "no");
    for (String words :
        List.of(
            "recommended          all,8,8: 100.0 MLUPS with 2 threads at 20^3",
            "cost of bundles      16.7 % against one block a thread (120.0 MLUPS)",
            "efficiency  ideal  of ideal",
            "speed-up             1.67, efficiency 83.3 %; 83.3 % of the ideal; the bandwidth's own"
                + " speed-up: 1.80",
            "at 30^3              99.0 MLUPS, 10.0 % behind the best there (10)",
            "stored               no")) {
      assertTrue(text.contains(words), () -> words + " <- " + text);
    }
    assertTrue(text.chars().allMatch(c -> c < 128), "terminals without UTF-8 print ASCII only");
  }
}
