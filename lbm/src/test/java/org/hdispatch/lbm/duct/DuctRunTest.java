package org.hdispatch.lbm.duct;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.lbm.duct.DuctRun.Ending;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DuctRunTest {
  private final BandwidthProbe probe = new BandwidthProbe(4 << 20);

  private static Duct duct(int side) {
    return new Duct(
        side,
        VelocitySet.D3Q15,
        new BundleSize(side, 4, 4),
        Streaming.IN_PLACE,
        Storage.DOUBLE,
        KernelForm.SCALAR);
  }

  private DuctFigures measure(DuctRun run, int workers, DuctRun.Listener listener) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      return run.measure(dispatcher, duct(16), probe, listener);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void measuredStepsAllocateNothing(int workers) {
    DuctRun run = new DuctRun(2000, 40, Ending.MEASURED);
    DuctFigures figures = measure(run, workers, DuctRun.Listener.NONE);
    for (int again = 0; again < 4 && figures.stats().bytesPerStep() > 0; again++) {
      figures = measure(run, workers, DuctRun.Listener.NONE); // the JVM still replaced code
    }
    assertEquals(0, figures.stats().bytesPerStep());
    assertEquals(40, figures.stats().steps());
    assertEquals(2040, figures.lastStep());
  }

  @Test
  void figuresFollowFromTheReadings() {
    DuctFigures figures = measure(new DuctRun(10, 6, Ending.MEASURED), 1, DuctRun.Listener.NONE);
    assertTrue(figures.secondsPerStep().least() > 0);
    assertTrue(figures.gigabytesPerSecond().least() > 0);
    double mlups = 16 * 16 * 16 / figures.secondsPerStep().median() * 1e-6;
    assertEquals(mlups, figures.mlupsMedian(), 1e-12 * mlups);
    assertTrue(figures.mlupsBest() >= figures.mlupsMedian());
    double limit = figures.gigabytesPerSecond().median() * 1e9 / 240;
    assertEquals(limit * 1e-6, figures.bandwidthMlups(), 1e-12 * limit);
    double moved = mlups * 1e-3 * 240; // GB/s
    assertEquals(moved / figures.gigabytesPerSecond().median(), figures.bandwidthFraction(), 1e-12);
    assertEquals(16, figures.bundles());
    assertTrue(figures.bytesHeldPerNode() > 120);
    assertFalse(figures.steady());
  }

  @Test
  void steadyEndingStepsOnUntilTheFlowIsSteady() {
    DuctRun run = new DuctRun(4, 4, Ending.STEADY);
    DuctFigures figures = measure(run, 2, DuctRun.Listener.NONE);
    assertTrue(figures.steady());
    assertEquals(duct(16).stepsUntil(DuctRun.STEADY), figures.lastStep());
    assertEquals(4, figures.stats().steps());
    // 0.58 % at W = 16: the figure of docs/validation.md, for half-way bounce-back
    assertEquals(1.0058, figures.kOverW2() / Duct.K_OVER_W2, 2e-4);
  }

  @Test
  void listenerHearsWarmUpMeasuringAndProgress() {
    List<String> heard = new ArrayList<>();
    measure(
        new DuctRun(3, 8, Ending.MEASURED),
        1,
        new DuctRun.Listener() {
          @Override
          public void started() {
            heard.add("started");
          }

          @Override
          public void warmedUp() {
            heard.add("warm");
          }

          @Override
          public void progressed(long step, long lastStep) {
            heard.add(step + "/" + lastStep);
          }

          @Override
          public void measured() {
            heard.add("measured");
          }
        });
    assertEquals(
        List.of("started", "3/11", "warm", "5/11", "7/11", "9/11", "11/11", "measured"), heard);
  }

  @Test
  void warmUpIsLongerForSmallDucts() {
    assertEquals(24, DuctRun.warmUpFor(duct(200)));
    assertEquals(100, DuctRun.warmUpFor(duct(100)));
    assertEquals(10_000, DuctRun.warmUpFor(duct(10)));
  }

  @Test
  void refusesTooFewSteps() {
    assertThrows(IllegalArgumentException.class, () -> new DuctRun(0, 2, Ending.MEASURED));
    assertThrows(IllegalArgumentException.class, () -> new DuctRun(1, 0, Ending.MEASURED));
    assertThrows(IllegalArgumentException.class, () -> new DuctRun(1, 3, Ending.MEASURED));
  }

  @Test
  void medianOfAnEvenNumberIsTheMeanOfTheTwoInTheMiddle() {
    assertEquals(new Spread(1, 2.5, 9), Spread.of(new double[] {3, 1, 9, 2}));
    assertEquals(new Spread(1, 3, 9), Spread.of(new double[] {3, 1, 9}));
    assertThrows(IllegalArgumentException.class, () -> Spread.of(new double[0]));
  }

  @Test
  void probeHasWholeArraysAndAtLeastOne() {
    assertEquals(4 << 20, probe.bytes());
    assertEquals(1 << 18, new BandwidthProbe(0).bytes());
  }
}
