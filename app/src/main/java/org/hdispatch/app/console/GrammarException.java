package org.hdispatch.app.console;

import picocli.CommandLine.TypeConversionException;

/** A text that is not of the form that an argument asks for. */
public final class GrammarException extends TypeConversionException {
  private static final long serialVersionUID = 1L;

  private final String grammar;

  /**
   * Refuses a text.
   *
   * @param grammar what it must look like
   */
  public GrammarException(String grammar) {
    super("text must be " + grammar);
    this.grammar = grammar;
  }

  /** What the text must look like. */
  String grammar() {
    return grammar;
  }
}
