package org.hdispatch.app;

import java.io.PrintWriter;

/** One line on a terminal, written over and over, and wiped in the end. */
final class StatusLine implements AutoCloseable {
  private final PrintWriter err;
  private int width;

  StatusLine(PrintWriter err) {
    this.err = err;
  }

  void show(String line) {
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
