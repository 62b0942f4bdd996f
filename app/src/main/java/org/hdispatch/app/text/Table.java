package org.hdispatch.app.text;

/** Lines of a name and what is to be said about it. */
public final class Table {
  private static final int NAME_WIDTH = 21;

  private final StringBuilder text = new StringBuilder();

  /** Adds a line; a name may be empty, below another. */
  public Table line(String name, String value) {
    text.append(name)
        .append(" ".repeat(Math.max(1, NAME_WIDTH - name.length())))
        .append(value)
        .append(System.lineSeparator());
    return this;
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
