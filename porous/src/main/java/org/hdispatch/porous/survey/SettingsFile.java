package org.hdispatch.porous.survey;

import static java.nio.file.StandardOpenOption.CREATE;
import static java.nio.file.StandardOpenOption.READ;
import static java.nio.file.StandardOpenOption.WRITE;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.hdispatch.porous.io.ImageFileException;

/**
 * The file of the settings, which is also the lock that keeps other processes from the rows beside
 * it: it is written once and never replaced.
 *
 * <p>On POSIX systems a process loses its lock on a file as soon as it closes the file anywhere,
 * and it is never in its own way. So the files that this process holds are known by their names:
 * none is opened again, and what they hold is read through the channel that is open.
 */
final class SettingsFile implements AutoCloseable {
  /** The locked byte lies behind all content, so that locked content may be read everywhere. */
  private static final long LOCKED = Long.MAX_VALUE - 1;

  /** What this process holds: it belongs to the process as the locks themselves do. */
  private static final Map<Path, SettingsFile> HELD = new HashMap<>(); // guarded by itself

  private final Path file;
  private final Path real;
  private final FileChannel channel;

  private SettingsFile(Path file, Path real, FileChannel channel) {
    this.file = file;
    this.real = real;
    this.channel = channel;
  }

  /**
   * Takes hold of a file; makes it if it is not there.
   *
   * @throws ImageFileException if it cannot be written, or somebody has hold of it
   */
  static SettingsFile hold(Path file) throws ImageFileException {
    SettingsFile held;
    synchronized (HELD) {
      try {
        Path real = real(file);
        if (HELD.containsKey(real)) {
          throw taken(file);
        }
        held = new SettingsFile(file, real, FileChannel.open(file, CREATE, READ, WRITE));
        HELD.put(real, held);
      } catch (IOException e) {
        throw failed(file, e);
      }
    }
    try {
      if (held.channel.tryLock(LOCKED, 1, false) == null) {
        throw taken(file);
      }
      return held;
    } catch (OverlappingFileLockException e) { // by a class of this name of another class loader
      held.close();
      throw taken(file);
    } catch (IOException e) {
      held.close();
      throw failed(file, e);
    }
  }

  /** Its one name, whatever links lead to it. */
  private static Path real(Path file) throws IOException {
    return file.toAbsolutePath().getParent().toRealPath().resolve(file.getFileName());
  }

  private static ImageFileException taken(Path file) {
    return new ImageFileException(
        "rows must be written by one process at a time (another one is at it): file=" + file);
  }

  private static ImageFileException failed(Path file, IOException e) {
    return e instanceof ImageFileException known
        ? known
        : new ImageFileException("settings must be kept: file=" + file + ", cause=" + e, e);
  }

  /**
   * What a file holds that somebody else may have hold of; empty if nothing, or a part of it.
   *
   * @throws ImageFileException if it cannot be read
   */
  static Optional<SurveySettings> readOther(Path file) throws ImageFileException {
    synchronized (HELD) {
      try {
        SettingsFile held = HELD.get(real(file));
        return held != null ? held.read() : SurveySettings.parse(Files.readString(file));
      } catch (IOException e) {
        throw failed(file, e);
      }
    }
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
    synchronized (HELD) {
      try {
        channel.close();
      } catch (IOException e) {
        // It was forced to the disk when it was written, and nobody can hold a closed channel.
      }
      HELD.remove(real, this);
    }
  }
}
