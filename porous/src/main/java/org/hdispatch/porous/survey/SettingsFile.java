package org.hdispatch.porous.survey;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.hdispatch.porous.io.ImageFileException;

/**
 * The file of the settings, which is also the lock that keeps other processes from the rows beside
 * it: it is written once and never replaced.
 */
final class SettingsFile implements AutoCloseable {
  /** The locked byte lies behind all content, so that locked content may be read everywhere. */
  private static final long LOCKED = Long.MAX_VALUE - 1;

  private final Path file;
  private final FileChannel channel;

  private SettingsFile(Path file, FileChannel channel) {
    this.file = file;
    this.channel = channel;
  }

  /**
   * Takes hold of a file; makes it if it is not there.
   *
   * @throws ImageFileException if it cannot be written, or another process has hold of it
   */
  static SettingsFile hold(Path file) throws ImageFileException {
    try {
      SettingsFile held =
          new SettingsFile(
              file,
              FileChannel.open(
                  file,
                  StandardOpenOption.CREATE,
                  StandardOpenOption.READ,
                  StandardOpenOption.WRITE));
      if (!held.isLocked()) {
        held.channel.close();
        throw new ImageFileException(
            "rows must be written by one process at a time (another one is at it): file=" + file);
      }
      return held;
    } catch (IOException e) {
      throw failed(file, e);
    }
  }

  private boolean isLocked() throws IOException {
    try {
      return channel.tryLock(LOCKED, 1, false) != null;
    } catch (OverlappingFileLockException e) {
      return false; // by this very process
    }
  }

  private static ImageFileException failed(Path file, IOException e) {
    return e instanceof ImageFileException known
        ? known
        : new ImageFileException("settings must be kept: file=" + file + ", cause=" + e, e);
  }

  /** What it holds; empty if nothing, or a part of it. */
  Optional<SurveySettings> read() throws ImageFileException {
    try {
      ByteBuffer bytes = ByteBuffer.allocate(Math.toIntExact(channel.size()));
      while (bytes.hasRemaining() && channel.read(bytes, bytes.position()) > 0) {
        continue;
      }
      return SurveySettings.parse(
          new String(bytes.array(), 0, bytes.position(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw failed(file, e);
    }
  }

  /** Writes settings; when this returns, they are on the disk. */
  void write(SurveySettings settings) throws ImageFileException {
    try {
      channel.truncate(0);
      ByteBuffer bytes = StandardCharsets.UTF_8.encode(settings.format());
      while (bytes.hasRemaining()) {
        channel.write(bytes, bytes.position());
      }
      channel.force(true);
    } catch (IOException e) {
      throw failed(file, e);
    }
  }

  /** Lets go of the file. */
  @Override
  public void close() {
    try {
      channel.close();
    } catch (IOException e) {
      // It was forced to the disk when it was written, and nobody can hold a closed channel.
    }
  }
}
