package org.hdispatch.bench.peer;

/** Says that this JVM does not offer a peer, in one line: JMH prints no stack and goes on. */
public final class UnavailablePeerException extends IllegalStateException {
  private static final long serialVersionUID = 1;

  UnavailablePeerException(String why) {
    super(why);
  }

  @Override
  public synchronized Throwable fillInStackTrace() {
    return this;
  }
}
