package org.hdispatch.app.watch;

import com.fasterxml.jackson.jr.ob.JSON;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryUsage;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Version;
import org.hdispatch.dispatch.LoopStats;
import org.hdispatch.gc.GcReport;
import org.hdispatch.gc.GcWatch;

/** What the garbage collector did, in all detail, as JSON; what was not measured is null. */
record GcReportJson(CollectorReport report) {
  private static final JSON TEXT =
      JSON.std.with(JSON.Feature.PRETTY_PRINT_OUTPUT, JSON.Feature.WRITE_NULL_PROPERTIES);

  /** One JSON object. */
  String text() {
    LoopStats stats = report.stats();
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("jvm", jvm());
    all.put("heap", heap());
    all.put("warm_up_steps", report.warmUpSteps());
    all.put("steps", stats.steps());
    all.put("seconds_stepping", stats.nanos() * 1e-9);
    all.put("bytes_per_step", CollectorReport.bytes(stats));
    all.put("workers", stats.workers().stream().map(GcReportJson::worker).toList());
    all.put(
        "windows",
        report.figures().stream()
            .flatMap(figures -> figures.details().stream())
            .map(GcReportJson::window)
            .toList());
    try {
      return TEXT.asString(all) + "\n";
    } catch (IOException e) {
      throw new UncheckedIOException("text must hold a report", e); // it is not a file
    }
  }

  private static Map<String, Object> jvm() {
    Map<String, Object> jvm = new LinkedHashMap<>();
    jvm.put("java", System.getProperty("java.version"));
    jvm.put("name", System.getProperty("java.vm.name"));
    jvm.put("vendor", System.getProperty("java.vendor"));
    jvm.put("collector", GcWatch.collector());
    jvm.put("arguments", ManagementFactory.getRuntimeMXBean().getInputArguments());
    jvm.put("processors", Runtime.getRuntime().availableProcessors());
    jvm.put("version_of_hdispatch", Version.ofProject());
    return jvm;
  }

  private static Map<String, Object> heap() {
    MemoryUsage usage = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage();
    Map<String, Object> heap = new LinkedHashMap<>();
    heap.put("initial_bytes", known(usage.getInit()));
    heap.put("most_bytes", known(usage.getMax()));
    heap.put("committed_bytes", usage.getCommitted());
    heap.put("used_bytes", usage.getUsed());
    return heap;
  }

  private static Map<String, Object> worker(LoopStats.WorkerStats stats) {
    Map<String, Object> worker = new LinkedHashMap<>();
    worker.put("cells", stats.cells());
    worker.put("stolen", stats.stolen());
    worker.put("busy_seconds", stats.busyNanos() * 1e-9);
    worker.put("allocated_bytes", known(stats.allocatedBytes()));
    return worker;
  }

  private static Map<String, Object> window(CollectorWatch.Detail detail) {
    GcReport gc = detail.report();
    Map<String, Object> window = new LinkedHashMap<>();
    window.put("window", Choices.word(detail.window()));
    window.put("source", Choices.word(gc.source()));
    window.put("collections", gc.collections());
    window.put("pauses", stops(gc.pauses()));
    window.put("stopped", stops(gc.safepoints()));
    window.put("reaching_ms", gc.safepoints().measured() ? millis(gc.reaching()) : null);
    window.put("stalls", stops(gc.stalls()));
    window.put("peak_heap_bytes", known(gc.peakHeapBytes()));
    window.put("timeline", gc.timeline().stream().map(GcReportJson::pause).toList());
    return window;
  }

  private static Map<String, Object> stops(GcReport.Stops stops) {
    if (!stops.measured()) {
      return null;
    }
    Map<String, Object> figures = new LinkedHashMap<>();
    figures.put("count", stops.count());
    figures.put("total_ms", millis(stops.total()));
    figures.put("p99_ms", millis(stops.p99()));
    figures.put("most_ms", millis(stops.longest()));
    return figures;
  }

  private static Map<String, Object> pause(GcReport.Pause pause) {
    Map<String, Object> figures = new LinkedHashMap<>();
    figures.put("at_ms", millis(pause.at()));
    figures.put("ms", millis(pause.length()));
    figures.put("name", pause.name());
    return figures;
  }

  private static double millis(Duration duration) {
    return duration.toNanos() * 1e-6;
  }

  private static Long known(long bytes) {
    return bytes < 0 ? null : bytes;
  }
}
