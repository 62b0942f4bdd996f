package org.hdispatch.sph;

/** The flow has blown up; the message says which particle shows it. */
public final class BlownUpException extends IllegalStateException {
  private static final long serialVersionUID = 1L;

  /**
   * Says what no longer holds.
   *
   * @param message what must hold, and the particle for which it does not
   */
  BlownUpException(String message) {
    super(message);
  }
}
