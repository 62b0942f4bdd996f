package org.hdispatch.app.watch;

import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.gc.GcReport;
import org.hdispatch.gc.GcWatch;
import org.hdispatch.porous.flow.FlowListener;

/**
 * Watches the garbage collector while a flow is stepped: from the first step to the last
 * measurement, warm-up apart. What the set-up before and the fields after make of garbage does not
 * count.
 */
public final class CollectorWatch implements FlowListener, AutoCloseable {
  private final GcWatch watch;
  private boolean begun;
  private boolean warm;

  private CollectorWatch(GcWatch watch) {
    this.watch = watch;
  }

  /**
   * Starts to watch by Flight Recorder, which takes up to half a second. To be called before the
   * set-up: in JDK 17 the first start of the recorder changes classes of the JDK, and with that the
   * JVM drops all code it has compiled so far.
   */
  public static CollectorWatch recording() {
    return new CollectorWatch(GcWatch.start());
  }

  /** Starts to count collections alone, at once: stops and stalls are not measured. */
  public static CollectorWatch counting() {
    return new CollectorWatch(GcWatch.startCounting());
  }

  /** A part of a run. */
  enum Part {
    /** Until the first step. */
    SET_UP,
    /** Steps before those that count. */
    WARM_UP,
    /** Steps that count. */
    STEPS,
    /** What is made of them. */
    REST
  }

  /**
   * All that is known of a part.
   *
   * @param window which
   * @param report what the collector did in it
   */
  record Detail(Part window, GcReport report) {}

  /**
   * What the collector did.
   *
   * @param warmUp during warm-up
   * @param after after warm-up
   * @param details part by part
   */
  public record Figures(Window warmUp, Window after, List<Detail> details) {}

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
    private static final Window NOTHING =
        new Window(0, OptionalDouble.of(0), OptionalDouble.of(0), OptionalDouble.of(0));

    private static Window of(GcReport report) {
      return new Window(
          report.collections(),
          millis(report.pauses()),
          millis(report.safepoints()),
          millis(report.stalls()));
    }

    private static OptionalDouble millis(GcReport.Stops stops) {
      return stops.measured()
          ? OptionalDouble.of(stops.total().toNanos() * 1e-6)
          : OptionalDouble.empty();
    }
  }

  @Override
  public void started(Start start) {
    begin();
  }

  /** Stepping begins. */
  public void begin() {
    watch.mark();
    begun = true;
  }

  @Override
  public void warmedUp() {
    watch.mark();
    warm = true;
  }

  @Override
  public void stepped() {
    watch.mark();
  }

  /**
   * Ends the watch. A run too short to have a warm-up counts as a whole.
   *
   * @throws UncheckedIOException if the record of the collector cannot be read
   */
  public Figures figures() {
    List<GcReport> reports = watch.stop();
    List<Detail> details = new ArrayList<>();
    for (Part part : Part.values()) {
      if (details.size() < reports.size() && (warm || part != Part.WARM_UP)) {
        details.add(new Detail(part, reports.get(details.size())));
      }
    }
    if (!begun) {
      return new Figures(Window.NOTHING, Window.NOTHING, details); // nothing was stepped
    }
    return warm // reports.get(0) is the set-up
        ? new Figures(Window.of(reports.get(1)), Window.of(reports.get(2)), details)
        : new Figures(Window.NOTHING, Window.of(reports.get(1)), details);
  }

  /**
   * Ends the watch; where the record of the collector cannot be read, warns.
   *
   * @param console where to
   * @return what the collector did, if that can be read
   */
  public Optional<Figures> figures(CommandConsole console) {
    try {
      return Optional.of(figures());
    } catch (UncheckedIOException e) { // a pity, but the result is worth more
      console.warn("figures of the collector must be readable: cause=" + e.getCause());
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    watch.close();
  }
}
