package org.hdispatch.gc;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;

/** One report for each window of a finished recording. */
final class RecordedWindows {

  /** The events that are needed; one that a JDK does not know is simply never seen. */
  static final List<String> EVENTS =
      List.of(
          "jdk.GarbageCollection",
          "jdk.GCPhasePause",
          "jdk.SafepointBegin",
          "jdk.SafepointEnd",
          "jdk.ZAllocationStall");

  private final List<Instant> edges = new ArrayList<>();
  private final List<RecordedEvent> events = new ArrayList<>();
  private final Map<Long, Instant> safepointEnds = new HashMap<>();

  private RecordedWindows() {}

  static List<GcReport> read(Path file, long watch, String collector) throws IOException {
    RecordedWindows recorded = new RecordedWindows();
    try (RecordingFile recording = new RecordingFile(file)) {
      while (recording.hasMoreEvents()) {
        recorded.add(recording.readEvent(), watch);
      }
    }
    return recorded.reports(collector);
  }

  private void add(RecordedEvent event, long watch) {
    switch (event.getEventType().getName()) {
      case WindowMark.NAME -> {
        if (event.getLong("watch") == watch) {
          edges.add(event.getStartTime());
        }
      }
      case "jdk.SafepointEnd" ->
          safepointEnds.put(event.getLong("safepointId"), event.getEndTime());
      default -> {
        if (EVENTS.contains(event.getEventType().getName())) { // another recording may ask for more
          events.add(event);
        }
      }
    }
  }

  private List<GcReport> reports(String collector) {
    edges.sort(Comparator.naturalOrder());
    List<GcReport> reports = new ArrayList<>();
    for (int window = 0; window + 1 < edges.size(); window++) {
      reports.add(report(collector, edges.get(window), edges.get(window + 1)));
    }
    return List.copyOf(reports);
  }

  private GcReport report(String collector, Instant from, Instant to) {
    Set<Integer> collections = new HashSet<>(); // by id: one collection may report more than once
    GcReport.Stops pauses = GcReport.Stops.NONE;
    GcReport.Stops safepoints = GcReport.Stops.NONE;
    GcReport.Stops stalls = GcReport.Stops.NONE;
    for (RecordedEvent event : events) {
      Instant begin = event.getStartTime();
      if (begin.isBefore(from) || !begin.isBefore(to)) {
        continue;
      }
      switch (event.getEventType().getName()) {
        case "jdk.GarbageCollection" -> collections.add(event.getInt("gcId"));
        case "jdk.GCPhasePause" -> pauses = pauses.plus(event.getDuration());
        case "jdk.SafepointBegin" -> safepoints = safepoints.plus(stopped(event));
        case "jdk.ZAllocationStall" -> stalls = stalls.plus(event.getDuration());
        default -> {}
      }
    }
    return new GcReport(
        collector, GcReport.Source.FLIGHT_RECORDER, collections.size(), pauses, safepoints, stalls);
  }

  /** From the request until the threads ran again. */
  private Duration stopped(RecordedEvent begin) {
    Instant end = safepointEnds.getOrDefault(begin.getLong("safepointId"), begin.getEndTime());
    return Duration.between(begin.getStartTime(), end);
  }
}
