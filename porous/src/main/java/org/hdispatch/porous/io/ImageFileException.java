package org.hdispatch.porous.io;

import java.io.IOException;

/**
 * A file that is missing, unreadable or wrong, or that cannot be written.
 *
 * <p>The message is one line that says what must hold and names the file, and the remedy where
 * there is one.
 */
public final class ImageFileException extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * An exception with its line.
   *
   * @param message what must hold, and the values that do not
   */
  public ImageFileException(String message) {
    super(oneLine(message));
  }

  /**
   * An exception with its line and what lay behind it.
   *
   * @param message what must hold, and the values that do not
   * @param cause what was caught
   */
  public ImageFileException(String message, Throwable cause) {
    super(oneLine(message), cause);
  }

  private static String oneLine(String message) {
    return message.replaceAll("\\s*\\R\\s*", " ");
  }
}
