package org.hdispatch.app.console;

import java.io.PrintWriter;

/** One line on a terminal, written over and over, and wiped in the end. */
public final class StatusLine implements AutoCloseable {
  private final PrintWriter err;
  private int width;

  /**
   * Makes an empty line.
   *
   * @param err the terminal
   */
  public StatusLine(PrintWriter err) {
    this.err = err;
  }

  /** Writes over what stands there. */
  public void show(String line) {
    err.print("\r" + line + " ".repeat(Math.max(0, width - line.length())));
    err.flush();
    width = line.length();
  }

  /** Wipes the line. */
  @Override
  public void close() {
    if (width > 0) {
      err.print("\r" + " ".repeat(width) + "\r");
      err.flush();
      width = 0;
    }
  }
}
