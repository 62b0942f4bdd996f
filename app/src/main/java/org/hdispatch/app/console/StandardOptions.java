package org.hdispatch.app.console;

import picocli.CommandLine.Option;

/** What every command understands. */
public final class StandardOptions {
  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Show this help and exit.")
  private boolean help;

  @Option(
      names = {"-V", "--version"},
      versionHelp = true,
      description = "Show the versions of H-Dispatch, Java and the collector, and exit.")
  private boolean version;

  @Option(names = "--stacktrace", description = "Show the stack trace of an error.")
  private boolean stacktrace;
}
