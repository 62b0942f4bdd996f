package org.hdispatch.app.study;

import java.io.File;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Starts JVMs on the classes of this one, each in a folder.
 *
 * @param jdk whose JVM
 * @param folder working folder of the children, which holds what they print while they run
 */
public record ChildJvm(Jdk jdk, Path folder) {
  private static final String OUT = "out.txt";
  private static final String ERR = "err.txt";

  /** In place of the exit code of a child that was ended, as it took too long. */
  static final int TOO_LONG = -1;

  private static final Duration FOREVER = Duration.ofDays(365);

  /**
   * How a child ended.
   *
   * @param code its exit code, or {@link #TOO_LONG}
   * @param out what it printed on standard output
   * @param err on standard error
   */
  public record Ended(int code, String out, String err) {
    /** The last line of standard error, or else of standard output, that says anything. */
    public String lastWords() {
      return Stream.of(err, out)
          .flatMap(
              text -> text.lines().filter(line -> !line.isBlank()).reduce((a, b) -> b).stream())
          .findFirst()
          .orElse("");
    }
  }

  /**
   * Whether the JVM starts with these options.
   *
   * @throws IOException if no process can be started
   */
  public boolean knows(List<String> options) throws IOException {
    List<String> command = new ArrayList<>(List.of(jdk.java().toAbsolutePath().toString()));
    command.addAll(options);
    command.add("-version");
    return end(command, FOREVER).code() == 0;
  }

  /**
   * Runs a program to its end.
   *
   * @param options of the JVM
   * @param program class with a main method
   * @param args of that
   * @throws IOException if no process can be started, or what it printed cannot be read
   * @throws CancellationException if this thread was interrupted; the child is ended
   */
  public Ended run(List<String> options, Class<?> program, List<String> args) throws IOException {
    return run(options, program, args, FOREVER);
  }

  /** As the other, but after some time the child is ended. */
  Ended run(List<String> options, Class<?> program, List<String> args, Duration patience)
      throws IOException {
    List<String> command = new ArrayList<>(List.of(jdk.java().toAbsolutePath().toString()));
    command.addAll(options);
    command.addAll(List.of("-cp", classPath(), program.getName()));
    command.addAll(args);
    return end(command, patience);
  }

  private Ended end(List<String> command, Duration patience) throws IOException {
    // Its own: a JVM that dies leaves what Flight Recorder has written.
    Path temporary = Files.createTempDirectory(folder, "tmp");
    command.add(1, "-Djava.io.tmpdir=" + temporary.toAbsolutePath());
    File out = folder.resolve(OUT).toFile(); // files: a pipe that nobody reads fills up
    File err = folder.resolve(ERR).toFile();
    Process process = null;
    try {
      process =
          new ProcessBuilder(command)
              .directory(folder.toFile())
              .redirectOutput(out)
              .redirectError(err)
              .start();
      boolean inTime = process.waitFor(patience.toMillis(), TimeUnit.MILLISECONDS);
      if (Thread.interrupted()) { // Ctrl-C ends the child too
        throw new InterruptedException();
      }
      return new Ended(inTime ? process.exitValue() : TOO_LONG, text(out), text(err));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException("a child JVM was waited for");
    } finally {
      if (process != null) { // it was started
        process.destroyForcibly().onExit().join(); // at once, if it has ended
      }
      try (Stream<Path> left = Files.walk(temporary)) {
        for (Path each : left.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(each);
        }
      }
      Files.deleteIfExists(out.toPath());
      Files.deleteIfExists(err.toPath());
    }
  }

  private static String text(File file) throws IOException {
    return new String(Files.readAllBytes(file.toPath()), Charset.defaultCharset());
  }

  /** Classes and modules of this JVM, in absolute places: a child has another folder. */
  static String classPath() {
    return Stream.of("java.class.path", "jdk.module.path")
        .map(System::getProperty)
        .filter(path -> path != null && !path.isEmpty())
        .flatMap(path -> Arrays.stream(path.split(File.pathSeparator)))
        .map(entry -> Path.of(entry).toAbsolutePath().toString())
        .collect(Collectors.joining(File.pathSeparator));
  }
}
