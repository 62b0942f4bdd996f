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
          "jdk.GCHeapSummary",
          "jdk.SafepointBegin",
          "jdk.SafepointStateSynchronization",
          "jdk.SafepointEnd",
          "jdk.ZAllocationStall");

  private final List<Instant> edges = new ArrayList<>();
  private final List<RecordedEvent> events = new ArrayList<>();
  private final Map<Long, Instant> safepointEnds = new HashMap<>(); // by id of the safepoint
  private final Map<Long, Instant> reached = new HashMap<>(); // all threads have stopped

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
      case "jdk.SafepointStateSynchronization" ->
          reached.put(event.getLong("safepointId"), event.getEndTime());
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
    List<GcReport.Pause> pauses = new ArrayList<>();
    List<Duration> safepoints = new ArrayList<>();
    List<Duration> stalls = new ArrayList<>();
    Duration reaching = Duration.ZERO;
    long peak = -1;
    for (RecordedEvent event : events) {
      Instant begin = event.getStartTime();
      if (begin.isBefore(from) || !begin.isBefore(to)) {
        continue;
      }
      switch (event.getEventType().getName()) {
        case "jdk.GarbageCollection" -> collections.add(event.getInt("gcId"));
        case "jdk.GCPhasePause" ->
            pauses.add(
                new GcReport.Pause(
                    Duration.between(from, begin), event.getDuration(), event.getString("name")));
        case "jdk.GCHeapSummary" -> peak = Math.max(peak, event.getLong("heapUsed"));
        case "jdk.SafepointBegin" -> {
          safepoints.add(until(safepointEnds, event));
          reaching = reaching.plus(until(reached, event));
        }
        case "jdk.ZAllocationStall" -> stalls.add(event.getDuration());
        default -> {}
      }
    }
    pauses.sort(Comparator.comparing(GcReport.Pause::at));
    return new GcReport(
        collector,
        GcReport.Source.FLIGHT_RECORDER,
        collections.size(),
        GcReport.Stops.of(pauses.stream().map(GcReport.Pause::length).toList()),
        GcReport.Stops.of(safepoints),
        GcReport.Stops.of(stalls),
        reaching,
        pauses,
        peak);
  }

  /** From the request for a safepoint until an instant of it. */
  private static Duration until(Map<Long, Instant> instants, RecordedEvent begin) {
    Instant instant = instants.getOrDefault(begin.getLong("safepointId"), begin.getEndTime());
    return Duration.between(begin.getStartTime(), instant);
  }
}
