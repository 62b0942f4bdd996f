package org.hdispatch.app;

import java.util.function.Supplier;

/** The arguments cannot be meant so; the message is the line that the user sees. */
final class UsageException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  UsageException(String message) {
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
  static <T> T orRefused(Supplier<T> made) {
    try {
      return made.get();
    } catch (IllegalArgumentException e) {
      throw new UsageException(e);
    }
  }
}
