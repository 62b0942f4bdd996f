package org.hdispatch.gc;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import jdk.jfr.FlightRecorder;
import jdk.jfr.Recording;

/**
 * A record of every collection, pause, safepoint and stall of this JVM while it is open, cut into
 * windows.
 *
 * <pre>{@code
 * try (GcWatch watch = GcWatch.start()) {
 *   loop.run(warmUp);
 *   watch.mark();
 *   loop.run(steps);
 *   List<GcReport> windows = watch.stop(); // [0] warm-up, [1] the rest
 * }
 * }</pre>
 *
 * <p>Recorded with JDK Flight Recorder and read after the end, so nothing that happened in a window
 * comes late; an event belongs to the window in which it began. A concurrent collection that is
 * still under way when the watch stops is not counted, for its event is written at its end.
 * Starting and stopping the recorder themselves stop all threads for a moment: both lie outside the
 * windows. While open, the recorder writes to the folder of temporary files and allocates a little
 * on threads of its own.
 *
 * <p>The recorder takes a third to half a second to start. {@link #startCounting} does without it,
 * where it is enough to know that nothing was collected.
 *
 * <p>For one thread. Several watches may be open at the same time.
 */
public final class GcWatch implements AutoCloseable {

  private final Recording recording; // null: beans only
  private final List<long[]> beanReadings = new ArrayList<>(); // collections, pauses, pause ms
  private List<GcReport> windows;

  private GcWatch(Recording recording) {
    this.recording = recording;
  }

  /**
   * Starts to watch; the first window begins when this returns.
   *
   * @return an open watch
   */
  public static GcWatch start() {
    GcWatch watch = new GcWatch(FlightRecorder.isAvailable() ? startRecording() : null);
    watch.mark();
    return watch;
  }

  /**
   * Starts to watch by the management beans alone, at once; the first window begins when this
   * returns.
   *
   * @return an open watch whose reports are {@link GcReport.Source#BEANS}
   */
  public static GcWatch startCounting() {
    GcWatch watch = new GcWatch(null);
    watch.mark();
    return watch;
  }

  /**
   * Ends the current window and begins the next.
   *
   * @throws IllegalStateException if the watch was stopped or closed
   */
  public void mark() {
    if (windows != null) {
      throw new IllegalStateException("watch must be open to be marked");
    }
    if (recording == null) {
      beanReadings.add(CollectorBeans.read());
    } else {
      WindowMark.emit(recording.getId());
    }
  }

  /**
   * Ends the last window and the recording.
   *
   * @return one report for each window: from the start to the first mark, from mark to mark, from
   *     the last mark until now; the same list if called again
   * @throws UncheckedIOException if the recording cannot be written or read
   */
  public List<GcReport> stop() {
    if (windows == null) {
      mark();
      windows = recording == null ? CollectorBeans.reports(beanReadings) : readAndClose(recording);
    }
    return windows;
  }

  /** Ends the recording, without a report if {@link #stop} was not called before. */
  @Override
  public void close() {
    if (windows == null) {
      windows = List.of();
      if (recording != null) {
        recording.close();
      }
    }
  }

  /**
   * Name of the collector of this JVM.
   *
   * @return {@code Serial}, {@code Parallel}, {@code G1}, {@code ZGC}, {@code Shenandoah}, {@code
   *     Epsilon}, or what an unknown one calls itself
   */
  public static String collector() {
    return CollectorBeans.collector();
  }

  private static Recording startRecording() {
    Recording recording = null;
    try {
      recording = new Recording();
      recording.setName("H-Dispatch GC watch");
      for (String event : RecordedWindows.EVENTS) {
        recording.enable(event).withoutThreshold().withoutStackTrace();
      }
      recording.enable(WindowMark.class);
      recording.start();
      return recording;
    } catch (IllegalStateException e) {
      // documented for a recorder that cannot be set up, such as without a writable folder
      if (recording != null) {
        recording.close();
      }
      return null;
    }
  }

  private static List<GcReport> readAndClose(Recording recording) {
    try (recording) {
      recording.stop();
      Path file = Files.createTempFile("hdispatch-gc", ".jfr");
      try {
        recording.dump(file);
        return RecordedWindows.read(file, recording.getId(), collector());
      } finally {
        Files.deleteIfExists(file);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("recording of the collector must be readable", e);
    }
  }
}
