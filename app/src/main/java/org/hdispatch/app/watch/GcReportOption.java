package org.hdispatch.app.watch;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.WholeFiles;
import picocli.CommandLine.Option;

/** Where to write in detail what the garbage collector did. */
public final class GcReportOption {
  @Option(
      names = "--gc-report",
      paramLabel = "FILE",
      description =
          "Also write in detail what the garbage collector did, as JSON: set-up, warm-up and the"
              + " steps after it apart, every pause, bytes by worker, heap and arguments of the"
              + " JVM. Default: none.")
  private Path file;

  /** Starts to watch: in detail where the file is wanted, else by counts alone. */
  public CollectorWatch watch() {
    return file == null ? CollectorWatch.counting() : CollectorWatch.recording();
  }

  /**
   * Tries the file, before anything is computed.
   *
   * @throws ImageFileException if it cannot be written; nothing is left behind
   */
  public void check() throws ImageFileException {
    if (file == null) {
      return;
    }
    if (file.toString().isEmpty()) {
      throw new UsageException("--gc-report must name a file: --gc-report=");
    }
    if (Files.isDirectory(file)) {
      throw new ImageFileException("output must not be a directory: file=" + file);
    }
    try {
      Files.delete(Files.createTempFile(file.toAbsolutePath().getParent(), ".hdispatch", ".part"));
    } catch (IOException e) {
      throw new ImageFileException("output must be writable: file=" + file + ", cause=" + e, e);
    }
  }

  /**
   * Writes the file, if it is wanted; it is whole or not there.
   *
   * @throws ImageFileException if that cannot be done
   */
  public void write(CollectorReport report) throws ImageFileException {
    if (file == null) {
      return;
    }
    if (report.figures().isEmpty()) {
      throw new ImageFileException("figures of the collector must be readable: file=" + file);
    }
    ByteBuffer bytes = StandardCharsets.UTF_8.encode(new GcReportJson(report).text());
    WholeFiles.write(
        file,
        channel -> {
          while (bytes.hasRemaining()) {
            channel.write(bytes);
          }
        });
  }
}
