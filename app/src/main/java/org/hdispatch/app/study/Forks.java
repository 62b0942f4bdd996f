package org.hdispatch.app.study;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;

/** Runs cases of the study, each in a JVM of its own. */
final class Forks {
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
   * Runs a case.
   *
   * @param jdk whose JVM
   * @param heapBytes its heap
   * @param warmUpSeconds before the measurement
   * @param seconds of the measurement
   * @param patienceSeconds after which the JVM is ended
   * @return the row; one that says why, if the JVM died, refused or took too long
   * @throws IOException if it cannot be started, or files cannot be written
   * @throws CancellationException if this thread is interrupted; the JVM is ended then
   */
  GcRow run(
      GcCase what,
      Jdk jdk,
      long heapBytes,
      double warmUpSeconds,
      double seconds,
      double patienceSeconds)
      throws IOException {
    Path figures = folder.resolve("run.part");
    Path output = folder.resolve("output.part");
    try {
      Files.deleteIfExists(figures);
      Process jvm =
          new ProcessBuilder(
                  command(what, jdk, heapBytes, warmUpSeconds, seconds, figures.toString()))
              .redirectErrorStream(true)
              .redirectOutput(output.toFile())
              .start();
      boolean ended = waited(jvm, patienceSeconds);
      if (ended && jvm.exitValue() == 0 && Files.exists(figures)) {
        GcFigures read = RecordJson.read(GcFigures.class, Files.readString(figures));
        return new GcRow(what, "", Optional.of(read));
      }
      String why =
          ended
              ? why(Files.readAllLines(output), jvm.exitValue())
              : "no end within " + Math.round(patienceSeconds) + " s";
      return new GcRow(what, why, Optional.empty());
    } finally {
      Files.deleteIfExists(figures);
      Files.deleteIfExists(output);
    }
  }

  private static boolean waited(Process jvm, double seconds) {
    boolean ended = false;
    try {
      ended = jvm.waitFor((long) (1000 * seconds), TimeUnit.MILLISECONDS);
      return ended;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException();
    } finally {
      if (!ended) {
        jvm.destroyForcibly();
      }
    }
  }

  private List<String> command(
      GcCase what, Jdk jdk, long heapBytes, double warmUpSeconds, double seconds, String figures) {
    List<String> command = new ArrayList<>(List.of(jdk.java().toString()));
    command.addAll(what.collector().options());
    String heap = Long.toString(heapBytes);
    command.addAll(
        List.of(
            "-Xms" + heap,
            "-Xmx" + heap,
            "-XX:+AlwaysPreTouch",
            "-XX:+ExitOnOutOfMemoryError",
            "-Djdk.virtualThreadScheduler.parallelism=" + threads,
            "-Djdk.virtualThreadScheduler.maxPoolSize=" + threads));
    String main = StudyRun.class.getName();
    String classPath = System.getProperty("java.class.path");
    if (classPath == null || classPath.isEmpty()) {
      String modules = System.getProperty("jdk.module.path");
      command.addAll(
          List.of("-p", modules, "-m", StudyRun.class.getModule().getName() + "/" + main));
    } else {
      command.addAll(List.of("-cp", absolute(classPath), main));
    }
    command.addAll(
        List.of(
            what.workload().name(),
            what.policy().name(),
            Integer.toString(what.scratchBytes()),
            Integer.toString(threads),
            Double.toString(warmUpSeconds),
            Double.toString(seconds),
            heap,
            figures));
    return command;
  }

  private static String absolute(String classPath) {
    List<String> parts = new ArrayList<>();
    for (String part : classPath.split(File.pathSeparator)) {
      parts.add(Path.of(part).toAbsolutePath().toString());
    }
    return String.join(File.pathSeparator, parts);
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
    return "exit code " + exitValue;
  }
}
