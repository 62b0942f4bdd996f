package org.hdispatch.app.console;

import picocli.CommandLine.ParseResult;

/** What the user gave, as against defaults. */
public record Given(ParseResult parsed) {
  /** Whether an option was given. */
  public boolean has(String option) {
    return parsed.hasMatchedOption(option);
  }

  /**
   * Refuses an option that means nothing here.
   *
   * @param belongsTo with what it would mean something
   * @throws UsageException if it was given
   */
  public void refuse(String option, String belongsTo) {
    if (has(option)) {
      throw new UsageException(option + " must come with " + belongsTo);
    }
  }
}
