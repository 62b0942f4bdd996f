package org.hdispatch.app;

import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.hdispatch.gc.GcReport;
import org.hdispatch.gc.GcWatch;
import org.hdispatch.porous.flow.FlowListener;

/**
 * Watches the garbage collector while a flow is stepped: from the first step to the last
 * measurement, warm-up apart. What the set-up before and the fields after make of garbage does not
 * count.
 */
final class CollectorWatch implements FlowListener, AutoCloseable {
  private GcWatch watch;
  private int windows; // one ends at each measurement
  private int warmUpWindows;

  /**
   * What the collector did.
   *
   * @param warmUp during warm-up
   * @param after after warm-up
   */
  record Figures(Window warmUp, Window after) {}

  /**
   * What the collector did in a window.
   *
   * @param collections collections begun
   * @param pauseMillis stop-the-world work of the collector, ms
   * @param stoppedMillis all threads stopped, for whatever reason, ms; empty if not measured
   * @param stallMillis single threads held up for memory, ms; empty if not measured
   */
  record Window(
      long collections,
      OptionalDouble pauseMillis,
      OptionalDouble stoppedMillis,
      OptionalDouble stallMillis) {
    private static final Window NOTHING = of(List.of());

    private static Window of(List<GcReport> reports) {
      return new Window(
          reports.stream().mapToLong(GcReport::collections).sum(),
          millis(reports, GcReport::pauses),
          millis(reports, GcReport::safepoints),
          millis(reports, GcReport::stalls));
    }

    private static OptionalDouble millis(
        List<GcReport> reports, Function<GcReport, GcReport.Stops> kind) {
      if (!reports.stream().map(kind).allMatch(GcReport.Stops::measured)) {
        return OptionalDouble.empty();
      }
      Duration sum =
          reports.stream()
              .map(kind)
              .map(GcReport.Stops::total)
              .reduce(Duration.ZERO, Duration::plus);
      return OptionalDouble.of(sum.toNanos() * 1e-6);
    }
  }

  @Override
  public void started(Start start) {
    watch = GcWatch.start();
  }

  @Override
  public void progressed(Progress progress) {
    watch.mark();
    windows++;
  }

  @Override
  public void warmedUp() {
    warmUpWindows = windows;
  }

  /**
   * Ends the watch. A run too short to have a warm-up counts as a whole.
   *
   * @throws UncheckedIOException if the record of the collector cannot be read
   */
  Figures figures() {
    if (watch == null) {
      return new Figures(Window.NOTHING, Window.NOTHING); // nothing was stepped
    }
    List<GcReport> reports = watch.stop();
    return new Figures(
        Window.of(reports.subList(0, warmUpWindows)),
        Window.of(reports.subList(warmUpWindows, windows)));
  }

  @Override
  public void close() {
    if (watch != null) {
      watch.close();
    }
  }
}
