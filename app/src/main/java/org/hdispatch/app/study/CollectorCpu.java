package org.hdispatch.app.study;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Processor time of the threads of this JVM that collect garbage. Java knows nothing of them, but
 * Linux does, by their names; it also tells, to the nanosecond, for how long each has run.
 *
 * <p>The VM thread is among them: with Serial it collects, with others it stops the threads for the
 * collector and does a little of its work.
 */
final class CollectorCpu {
  private static final Path TASKS = Path.of("/proc/self/task");

  /** How names begin in HotSpot; Linux keeps 15 characters of each. */
  private static final List<String> NAMES =
      List.of(
          "VM Thread",
          "GC Thread",
          "G1 ",
          "ZWorker",
          "ZDriver",
          "ZDirector",
          "ZStat",
          "ZUnmapper",
          "ZUncommitter",
          "RuntimeWorker",
          "Shenandoah");

  private CollectorCpu() {}

  /** So far, ns; -1 where the operating system does not tell. */
  static long nanos() {
    return nanos(TASKS);
  }

  /** The same, of a folder that has a folder for each thread. */
  static long nanos(Path tasks) {
    long sum = 0;
    try (DirectoryStream<Path> all = Files.newDirectoryStream(tasks)) {
      for (Path each : all) {
        long nanos = ofThread(each);
        if (nanos < 0 && Files.exists(each)) { // else the thread has ended
          return -1;
        }
        sum += Math.max(0, nanos);
      }
      return sum;
    } catch (IOException | DirectoryIteratorException e) { // not Linux
      return -1;
    }
  }

  /** Time on a processor, 0 if the thread does not collect, -1 if that cannot be read. */
  private static long ofThread(Path task) {
    try {
      String name = Files.readString(task.resolve("comm"));
      return NAMES.stream().anyMatch(name::startsWith)
          // time on a processor, time waited for one, how often
          ? Long.parseLong(Files.readString(task.resolve("schedstat")).split(" ", 2)[0])
          : 0;
    } catch (IOException | NumberFormatException e) { // no such file, or of another form
      return -1;
    }
  }
}
