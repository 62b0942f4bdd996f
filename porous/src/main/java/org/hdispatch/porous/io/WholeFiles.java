package org.hdispatch.porous.io;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/**
 * Writes files that are either whole or not there.
 *
 * <p>The bytes go to {@code .NAME.PID.part} beside the target, which is moved over the target once
 * all is written and deleted when anything fails, also when the JVM is told to stop meanwhile.
 */
public final class WholeFiles {
  private WholeFiles() {}

  /** What is written into the file. */
  @FunctionalInterface
  public interface Content {
    /**
     * Writes everything.
     *
     * @param channel an empty file
     * @throws IOException if it cannot be written
     */
    void writeTo(FileChannel channel) throws IOException;
  }

  /**
   * Writes a file, over an existing one if need be.
   *
   * @param target where it goes; its folder must exist
   * @param content what to write
   * @throws ImageFileException if it cannot be written; nothing is left behind, and an existing
   *     target is as it was
   */
  public static void write(Path target, Content content) throws ImageFileException {
    Path absolute = target.toAbsolutePath();
    if (Files.isDirectory(absolute)) {
      throw new ImageFileException("output must not be a directory: file=" + target);
    }
    Path part =
        absolute.resolveSibling(
            "." + absolute.getFileName() + "." + ProcessHandle.current().pid() + ".part");
    try {
      part.toFile().deleteOnExit();
      try {
        try (FileChannel channel =
            FileChannel.open(
                part,
                StandardOpenOption.CREATE,
                StandardOpenOption.TRUNCATE_EXISTING,
                StandardOpenOption.WRITE)) {
          content.writeTo(channel);
          channel.force(true); // or else a power cut may leave an empty file under the name
        }
        move(part, absolute);
      } finally {
        Files.deleteIfExists(part);
      }
    } catch (IOException e) {
      throw new ImageFileException(
          "output must be writable: file=" + target + ", cause=" + ImageFiles.describe(e), e);
    }
  }

  /**
   * Writes a text as UTF-8, over an existing file if need be.
   *
   * @param target where it goes; its folder must exist
   * @param text what to write
   * @throws ImageFileException if it cannot be written; nothing is left behind, and an existing
   *     target is as it was
   */
  public static void write(Path target, String text) throws ImageFileException {
    ByteBuffer bytes = StandardCharsets.UTF_8.encode(text);
    write(
        target,
        channel -> {
          while (bytes.hasRemaining()) {
            channel.write(bytes);
          }
        });
  }

  /** What is written into a text, piece by piece. */
  @FunctionalInterface
  public interface Text {
    /**
     * Writes everything.
     *
     * @param out an empty text
     * @throws IOException if it cannot be written
     */
    void writeTo(Appendable out) throws IOException;
  }

  /**
   * Writes a text as UTF-8, piece by piece, over an existing file if need be.
   *
   * @param target where it goes; its folder must exist
   * @param text what to write
   * @throws ImageFileException if it cannot be written; nothing is left behind, and an existing
   *     target is as it was
   */
  public static void writeLines(Path target, Text text) throws ImageFileException {
    write(
        target,
        channel -> {
          BufferedWriter out =
              new BufferedWriter(Channels.newWriter(channel, StandardCharsets.UTF_8));
          text.writeTo(out);
          out.flush(); // the channel is forced to the disk, and then closed, by the caller
        });
  }

  private static void move(Path part, Path target) throws IOException {
    try {
      Files.move(part, target, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(part, target, StandardCopyOption.REPLACE_EXISTING);
    }
  }
}
