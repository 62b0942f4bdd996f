package org.hdispatch.app.console;

import java.io.PrintWriter;
import org.hdispatch.porous.io.ImageFileException;
import picocli.CommandLine.Model.CommandSpec;

/**
 * Where a command prints.
 *
 * @param spec the command
 * @param host whether somebody watches
 * @param quiet whether neither progress nor warnings are wanted
 */
public record CommandConsole(CommandSpec spec, Host host, boolean quiet) {
  /** Prints the result. */
  public void print(String text) throws ImageFileException {
    out().print(text);
    if (out().checkError()) {
      throw new ImageFileException("standard output must be writable");
    }
  }

  /** Whether progress is to be shown. */
  public boolean isWatched() {
    return host.terminal() && !quiet;
  }

  /** Standard output: the result. */
  public PrintWriter out() {
    return spec.commandLine().getOut();
  }

  /** Standard error: all but the result. */
  public PrintWriter err() {
    return spec.commandLine().getErr();
  }

  /** Warns in a line, if that is wanted. */
  public void warn(String line) {
    if (!quiet) {
      err().println("hdispatch: warning: " + line);
    }
  }
}
