package org.hdispatch.app.study;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;

/** Runs cases of the study, each in a JVM of its own. */
final class Forks {
  private static final String NO_END = "no end within ";
  private static final String EXIT = "exit code ";
  private static final int MOST_TO_TELL = 300; // characters

  private final Path folder;
  private final int threads;

  /**
   * Names where files may lie for a moment.
   *
   * @param folder exists
   * @param threads that step
   */
  Forks(Path folder, int threads) {
    this.folder = folder;
    this.threads = threads;
  }

  /**
   * How a JVM ended.
   *
   * @param why in one line, why there are no figures; empty if there are
   * @param figures what was measured; empty if it died, refused or took too long
   */
  record Outcome(String why, Optional<GcFigures> figures) {}

  /**
   * Runs a case.
   *
   * @param jdk whose JVM
   * @param heapBytes its heap
   * @param warmUpSeconds before the measurement
   * @param seconds of the measurement
   * @param patienceSeconds after which the JVM is ended
   * @throws IOException if it cannot be started, or files cannot be written
   * @throws CancellationException if this thread is interrupted; the JVM is ended then
   */
  Outcome run(
      GcCase what,
      Jdk jdk,
      long heapBytes,
      double warmUpSeconds,
      double seconds,
      double patienceSeconds)
      throws IOException {
    Path figures = folder.resolve("run.part").toAbsolutePath();
    try {
      Files.deleteIfExists(figures);
      List<String> args =
          List.of(
              what.workload().name(),
              what.policy().name(),
              Integer.toString(what.scratchBytes()),
              Integer.toString(threads),
              Double.toString(warmUpSeconds),
              Double.toString(seconds),
              Long.toString(heapBytes),
              figures.toString());
      Duration patience = Duration.ofMillis((long) (1000 * patienceSeconds));
      ChildJvm.Ended ended =
          new ChildJvm(jdk, folder)
              .run(options(what.collector(), heapBytes), StudyRun.class, args, patience);
      if (ended.code() == 0 && Files.exists(figures)) {
        GcFigures read = RecordJson.read(GcFigures.class, Files.readString(figures));
        return new Outcome("", Optional.of(read));
      }
      String why =
          ended.code() == ChildJvm.TOO_LONG
              ? NO_END + Math.round(patienceSeconds) + " s"
              : why(Stream.concat(ended.out().lines(), ended.err().lines()).toList(), ended.code());
      return new Outcome(why, Optional.empty());
    } finally {
      Files.deleteIfExists(figures);
    }
  }

  private List<String> options(Collector collector, long heapBytes) {
    List<String> options = new ArrayList<>(collector.options());
    options.addAll(
        List.of(
            "-Xms" + heapBytes,
            "-Xmx" + heapBytes,
            "-XX:+AlwaysPreTouch",
            "-XX:+ExitOnOutOfMemoryError",
            "-Djdk.virtualThreadScheduler.parallelism=" + threads,
            "-Djdk.virtualThreadScheduler.maxPoolSize=" + threads));
    return options;
  }

  /** Whether what ended a JVM may have come from outside, and another time would not. */
  static boolean isAccident(String why) {
    return why.startsWith(NO_END) || why.startsWith(EXIT);
  }

  /** What a JVM said before it died: the first line that is neither a warning nor of its log. */
  static String why(List<String> output, int exitValue) {
    for (int n = 0; n < output.size(); n++) {
      String line = output.get(n).strip();
      boolean aside =
          line.isEmpty()
              || line.startsWith("[")
              || line.toLowerCase(Locale.ROOT).contains("warning");
      if (!aside) {
        boolean headline = line.startsWith("Error occurred during initialization");
        String all =
            headline && n + 1 < output.size() ? line + ": " + output.get(n + 1).strip() : line;
        return all.length() > MOST_TO_TELL ? all.substring(0, MOST_TO_TELL) : all;
      }
    }
    return EXIT + exitValue;
  }
}
