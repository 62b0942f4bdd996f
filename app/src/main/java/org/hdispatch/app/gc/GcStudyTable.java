package org.hdispatch.app.gc;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcFigures;
import org.hdispatch.app.study.GcOrigin;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.Lbo;
import org.hdispatch.app.text.Columns;
import org.hdispatch.app.text.FlatRow;

/** The rows of a study of garbage collection, for people and for programs. */
final class GcStudyTable {
  private static final double MICRO = 1e6; // in a second
  private static final double MILLI = 1e-3; // of a microsecond

  private GcStudyTable() {}

  /** A table of the runs that have figures, then a line for each that has none. */
  static String text(List<GcRow> rows) {
    Lbo lbo = Lbo.of(rows);
    boolean several = rows.stream().anyMatch(row -> row.fork() > 1);
    Columns table =
        new Columns()
            .line(
                "run",
                "java",
                "heap",
                "policy",
                "steps/s",
                "us/cell",
                "+ other",
                "its gc",
                "cost",
                "gcs",
                "pause ms",
                "max",
                "stopped ms",
                "stalls",
                "p50 ms",
                "p90 ms",
                "bytes/step");
    StringBuilder dead = new StringBuilder();
    for (GcRow row : rows) {
      if (row.figures().isPresent()) {
        table.line(line(row, policy(row, several), row.figures().get(), lbo.cost(row)));
      } else {
        dead.append("no figures: ")
            .append(title(row.of()))
            .append(", ")
            .append(row.of().java())
            .append(", ")
            .append(row.of().heapFactor())
            .append("x, ")
            .append(policy(row, several))
            .append(": ")
            .append(row.why())
            .append(System.lineSeparator());
      }
    }
    return table.toString() + dead;
  }

  private static String[] line(GcRow row, String policy, GcFigures figures, OptionalDouble cost) {
    GcCase of = row.of();
    double cells = (double) figures.steps() * figures.cells();
    return new String[] {
      title(of),
      of.java(),
      of.heapFactor() + "x",
      policy,
      number("%.1f", figures.steps() / figures.seconds()),
      number("%.1f", MICRO * figures.workerCpuSeconds() / cells),
      number("%.1f", MICRO * figures.otherCpuSeconds() / cells),
      figures.collectorCpuSeconds() < 0
          ? "unknown"
          : number("%.1f", MICRO * figures.collectorCpuSeconds() / cells),
      cost.isPresent() ? number("%.2f", cost.getAsDouble()) : "",
      Long.toString(figures.collections()),
      millis(figures.pauses()),
      number("%.2f", figures.pauses().maxMillis()),
      millis(figures.stopped()),
      figures.stalls().count() < 0 ? "unknown" : Long.toString(figures.stalls().count()),
      number("%.1f", MILLI * figures.stepTimes().p50Micros()),
      number("%.1f", MILLI * figures.stepTimes().p90Micros()),
      figures.bytesPerStep() < 0 ? "unknown" : number("%.0f", figures.bytesPerStep())
    };
  }

  private static String title(GcCase of) {
    return of.workload().name().toLowerCase(Locale.ROOT)
        + ", "
        + (of.scratchBytes() >> 10)
        + " KiB, "
        + of.collector().title();
  }

  private static String policy(GcRow row, boolean several) {
    String name = row.of().policy().name().toLowerCase(Locale.ROOT).replace('_', ' ');
    return several ? name + " #" + row.fork() : name;
  }

  private static String millis(GcFigures.Stops stops) {
    return stops.count() < 0 ? "unknown" : number("%.1f", stops.totalMillis());
  }

  private static String number(String format, double value) {
    return String.format(Locale.ROOT, format, value);
  }

  /** The rows with the same keys each, for a CSV file. */
  static List<FlatRow> rows(List<GcRow> rows) {
    Lbo lbo = Lbo.of(rows);
    List<FlatRow> flat = new ArrayList<>();
    for (GcRow row : rows) {
      GcCase of = row.of();
      GcFigures figures = row.figures().orElse(null);
      FlatRow line =
          new FlatRow()
              .put("java", of.java())
              .put("collector", of.collector())
              .put("policy", of.policy())
              .put("workload", of.workload())
              .put("scratch_bytes", of.scratchBytes())
              .put("heap_factor", of.heapFactor())
              .put("why", row.why().isEmpty() ? null : row.why());
      put(line, figures);
      GcOrigin origin = row.origin();
      line.put("cost", lbo.cost(row))
          .put("collector_cpu_s", figures != null ? known(figures.collectorCpuSeconds()) : null)
          .put("fork", row.fork())
          .put("vendor", origin.vendor())
          .put("runtime", origin.runtime())
          .put("processor", origin.processor())
          .put("cores", origin.cores())
          .put("memory_gib", origin.memoryGib())
          .put("system", origin.system())
          .put("build", origin.build());
      flat.add(line);
    }
    return flat;
  }

  private static void put(FlatRow line, GcFigures figures) {
    boolean is = figures != null;
    GcFigures.StepTimes times = is ? figures.stepTimes() : null;
    line.put("heap_bytes", is ? figures.heapBytes() : null)
        .put("peak_heap_bytes", is ? figures.peakHeapBytes() : null)
        .put("workers", is ? figures.workers() : null)
        .put("cells", is ? figures.cells() : null)
        .put("steps", is ? figures.steps() : null)
        .put("seconds", is ? figures.seconds() : null)
        .put("worker_cpu_s", is ? figures.workerCpuSeconds() : null)
        .put("other_cpu_s", is ? figures.otherCpuSeconds() : null)
        .put("collections", is ? figures.collections() : null);
    put(line, "pause", is ? figures.pauses() : null);
    put(line, "stopped", is ? figures.stopped() : null);
    line.put("reaching_ms", is ? figures.reachingMillis() : null);
    put(line, "stall", is ? figures.stalls() : null);
    line.put("step_p50_us", is ? times.p50Micros() : null)
        .put("step_p90_us", is ? times.p90Micros() : null)
        .put("step_p99_us", is ? known(times.p99Micros()) : null)
        .put("step_p999_us", is ? known(times.p999Micros()) : null)
        .put("step_max_us", is ? times.maxMicros() : null)
        .put("bytes_per_step", is ? known(figures.bytesPerStep()) : null)
        .put("bytes_per_step_in_all", is ? known(figures.bytesPerStepInAll()) : null);
  }

  /** What was not measured is negative. */
  private static Double known(double value) {
    return value < 0 ? null : value;
  }

  private static void put(FlatRow line, String name, GcFigures.Stops stops) {
    boolean known = stops != null && stops.count() >= 0;
    line.put(name + "s", known ? stops.count() : null)
        .put(name + "_ms", known ? stops.totalMillis() : null)
        .put(name + "_p99_ms", known ? stops.p99Millis() : null)
        .put(name + "_max_ms", known ? stops.maxMillis() : null);
  }
}
