package org.hdispatch.porous.io;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The checks every file must pass before anybody reads it. */
final class ImageFiles {
  private ImageFiles() {}

  /**
   * Length of a file that exists, is a regular file, may be read and is not empty.
   *
   * @return its length, in bytes
   */
  static long requireReadable(Path file) throws ImageFileException {
    if (!Files.exists(file)) {
      throw new ImageFileException("file must exist: file=" + file);
    }
    if (Files.isDirectory(file)) {
      throw new ImageFileException("file must not be a directory: file=" + file);
    }
    if (!Files.isReadable(file)) {
      throw new ImageFileException("file must be readable: file=" + file);
    }
    try {
      long length = Files.size(file);
      if (length == 0) {
        throw new ImageFileException("file must not be empty: file=" + file + ", length=0 bytes");
      }
      return length;
    } catch (ImageFileException e) {
      throw e;
    } catch (IOException e) {
      throw unreadable(file, e);
    }
  }

  /** What to throw when the system refuses to read on. */
  static ImageFileException unreadable(Path file, IOException cause) {
    return new ImageFileException(
        "file must be readable: file=" + file + ", cause=" + describe(cause), cause);
  }

  /** A cause in words: Java's own file exceptions often carry nothing but the file name. */
  static String describe(Throwable cause) {
    if (cause instanceof AccessDeniedException) {
      return "access denied";
    }
    String message = cause.getMessage();
    String type = cause.getClass().getSimpleName();
    return message == null || message.isBlank() ? type : type + " (" + message + ")";
  }
}
