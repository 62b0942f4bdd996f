package org.hdispatch.app.console;

import java.util.function.Supplier;

/** The arguments cannot be meant so; the message is the line that the user sees. */
public final class UsageException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /**
   * Refuses arguments.
   *
   * @param message what must hold, and what was given
   */
  public UsageException(String message) {
    super(message);
  }

  private UsageException(IllegalArgumentException cause) {
    super(cause.getMessage(), cause);
  }

  /**
   * What is made of arguments, where whoever makes it checks them.
   *
   * @throws UsageException if it throws an {@link IllegalArgumentException}
   */
  public static <T> T orRefused(Supplier<T> made) {
    try {
      return made.get();
    } catch (IllegalArgumentException e) {
      throw new UsageException(e);
    }
  }
}
