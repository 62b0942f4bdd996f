package org.hdispatch.app.watch;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Table;
import org.hdispatch.dispatch.LoopStats;
import org.hdispatch.gc.GcWatch;

/**
 * What stepping left for the garbage collector, for people and for programs.
 *
 * @param figures what the collector did; empty if that could not be read
 * @param stats what the workers did after warm-up
 * @param warmUpSteps steps before that
 */
public record CollectorReport(
    Optional<CollectorWatch.Figures> figures, LoopStats stats, long warmUpSteps) {

  /** Adds lines, if anything was stepped and watched. */
  public void putInto(Table table) {
    if (figures.isEmpty() || warmUpSteps + stats.steps() == 0) {
      table.line("collector", GcWatch.collector());
      return;
    }
    CollectorWatch.Window after = figures.get().after();
    CollectorWatch.Window warmUp = figures.get().warmUp();
    long bytes = stats.bytesPerStep();
    table
        .line(
            "collector",
            GcWatch.collector()
                + ", "
                + after.collections()
                + " collections, pause "
                + millis(after.pauseMillis())
                + measured(", stopped ", after.stoppedMillis())
                + measured(", stall ", after.stallMillis()))
        .line(
            "allocated",
            (bytes < 0 ? "unknown" : Long.toString(bytes)) + " bytes per step (worst worker)")
        .line(
            "warm-up apart",
            warmUpSteps
                + " steps, "
                + warmUp.collections()
                + " collections, pause "
                + millis(warmUp.pauseMillis()));
  }

  private static String measured(String name, OptionalDouble millis) {
    return millis.isEmpty() ? "" : name + millis(millis);
  }

  private static String millis(OptionalDouble millis) {
    return millis.isEmpty()
        ? "unknown"
        : String.format(Locale.ROOT, "%.3g ms", millis.getAsDouble());
  }

  /** Adds keys and values. */
  public void putInto(FlatRow row) {
    Optional<CollectorWatch.Window> after = figures.map(CollectorWatch.Figures::after);
    Optional<CollectorWatch.Window> warmUp = figures.map(CollectorWatch.Figures::warmUp);
    row.put("collector", GcWatch.collector())
        .put("collections", after.map(CollectorWatch.Window::collections).orElse(null))
        .put("gc_pause_ms", millis(after, CollectorWatch.Window::pauseMillis))
        .put("stopped_ms", millis(after, CollectorWatch.Window::stoppedMillis))
        .put("stall_ms", millis(after, CollectorWatch.Window::stallMillis))
        .put("bytes_per_step", bytes(stats))
        .put("collections_warm_up", warmUp.map(CollectorWatch.Window::collections).orElse(null))
        .put("gc_pause_ms_warm_up", millis(warmUp, CollectorWatch.Window::pauseMillis))
        .put("warm_up_steps", warmUpSteps);
  }

  private static OptionalDouble millis(
      Optional<CollectorWatch.Window> window,
      Function<CollectorWatch.Window, OptionalDouble> figure) {
    return window.map(figure).orElse(OptionalDouble.empty());
  }

  /** Bytes that the worst worker allocated per step, or null if that is not known. */
  public static Long bytes(LoopStats stats) {
    long bytes = stats.bytesPerStep();
    return bytes == LoopStats.NOT_MEASURED ? null : bytes;
  }
}
