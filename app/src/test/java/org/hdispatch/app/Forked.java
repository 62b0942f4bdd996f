package org.hdispatch.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** The program in a JVM of its own, which can be killed. */
public final class Forked {
  private Forked() {}

  /** Starts a survey. */
  public static Process survey(List<String> jvm, String... args) throws IOException {
    List<String> all = new ArrayList<>(List.of("survey"));
    all.addAll(List.of(args));
    return program(jvm, all);
  }

  /** Starts a command. */
  public static Process program(List<String> jvm, List<String> args) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
    command.addAll(jvm);
    command.addAll(
        List.of("-cp", System.getProperty("java.class.path"), HDispatch.class.getName()));
    command.addAll(args);
    return new ProcessBuilder(command)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .redirectError(ProcessBuilder.Redirect.INHERIT)
        .start();
  }

  /** Its exit code, once it has ended. */
  public static int ended(Process process) throws InterruptedException {
    if (!process.waitFor(2, TimeUnit.MINUTES)) {
      process.destroyForcibly();
      throw new AssertionError("process must end");
    }
    return process.exitValue();
  }
}
