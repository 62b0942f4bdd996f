package org.hdispatch.bench.dispatch;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A process that keeps one core busy until it is destroyed or its parent ends. */
final class Spinner {
  /** The core it keeps to, where the system has {@code taskset}. */
  private static final String CORE = "1";

  private Spinner() {}

  /**
   * Starts one as a child of this JVM.
   *
   * @throws IllegalStateException if it does not run
   */
  static Process start() {
    List<String> command =
        List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-Xmx16m",
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            "-cp",
            System.getProperty("java.class.path"),
            Spinner.class.getName(),
            Long.toString(ProcessHandle.current().pid()));
    try {
      return running(pinned(command));
    } catch (IOException e) { // a system without taskset
      try {
        return running(command);
      } catch (IOException f) {
        throw new IllegalStateException("process that takes a core must start: " + command, f);
      }
    }
  }

  private static List<String> pinned(List<String> command) {
    List<String> pinned = new ArrayList<>(List.of("taskset", "-c", CORE));
    pinned.addAll(command);
    return pinned;
  }

  private static Process running(List<String> command) throws IOException {
    Process process = new ProcessBuilder(command).inheritIO().start();
    try {
      if (process.waitFor(500, TimeUnit.MILLISECONDS)) {
        throw new IllegalStateException(
            "process that takes a core must go on: exit=" + process.exitValue() + ", " + command);
      }
    } catch (InterruptedException e) {
      process.destroy();
      Thread.currentThread().interrupt();
      throw new IllegalStateException("process that takes a core must start", e);
    }
    return process;
  }

  /**
   * Spins.
   *
   * @param arguments the id of the parent process
   */
  public static void main(String[] arguments) {
    ProcessHandle parent = ProcessHandle.of(Long.parseLong(arguments[0])).orElseThrow();
    while (parent.isAlive()) {
      for (int spin = 0; spin < 10_000_000; spin++) {
        Thread.onSpinWait();
      }
    }
  }
}
