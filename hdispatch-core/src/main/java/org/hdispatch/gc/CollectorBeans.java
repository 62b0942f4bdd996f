package org.hdispatch.gc;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * What the management beans of the collector tell: its name, and, where Flight Recorder does not
 * watch, how often it collected.
 *
 * <p>ZGC and Shenandoah have beans whose name ends in "Cycles", whose time is concurrent and no
 * pause, and others that end in "Pauses", whose count is no collection. The beans of the other
 * collectors count stop-the-world collections (G1's concurrent cycle, where it has a bean, counts
 * as one collection, without a pause).
 */
final class CollectorBeans {

  private static final int COLLECTIONS = 0;
  private static final int PAUSES = 1;
  private static final int PAUSE_MILLIS = 2;

  private CollectorBeans() {}

  static String collector() {
    List<GarbageCollectorMXBean> beans = ManagementFactory.getGarbageCollectorMXBeans();
    String first = beans.isEmpty() ? "" : beans.get(0).getName();
    if (first.equals("Copy") || first.equals("MarkSweepCompact")) {
      return "Serial";
    }
    if (first.startsWith("PS ")) {
      return "Parallel";
    }
    for (String name : List.of("G1", "ZGC", "Shenandoah", "Epsilon")) {
      if (first.startsWith(name)) {
        return name;
      }
    }
    return beans.stream().map(GarbageCollectorMXBean::getName).collect(Collectors.joining(", "));
  }

  static long[] read() {
    long[] reading = new long[3];
    for (GarbageCollectorMXBean bean : ManagementFactory.getGarbageCollectorMXBeans()) {
      boolean cycles =
          bean.getName().endsWith("Cycles") || bean.getName().endsWith("Concurrent GC");
      if (!bean.getName().endsWith("Pauses")) {
        reading[COLLECTIONS] += bean.getCollectionCount();
      }
      if (!cycles) {
        reading[PAUSES] += bean.getCollectionCount();
        reading[PAUSE_MILLIS] += bean.getCollectionTime();
      }
    }
    return reading;
  }

  static List<GcReport> reports(List<long[]> readings) {
    List<GcReport> reports = new ArrayList<>();
    for (int window = 0; window + 1 < readings.size(); window++) {
      long[] from = readings.get(window);
      long[] to = readings.get(window + 1);
      Duration total = Duration.ofMillis(to[PAUSE_MILLIS] - from[PAUSE_MILLIS]);
      reports.add(
          new GcReport(
              collector(),
              GcReport.Source.BEANS,
              to[COLLECTIONS] - from[COLLECTIONS],
              new GcReport.Stops(to[PAUSES] - from[PAUSES], total, total, total),
              GcReport.Stops.NOT_MEASURED,
              GcReport.Stops.NOT_MEASURED,
              Duration.ZERO,
              List.of(),
              -1));
    }
    return List.copyOf(reports);
  }
}
