package org.hdispatch.app.draw;

/** What HTML and SVG have in common. */
public final class Markup {
  private Markup() {}

  /** A text as it may stand between tags, or between double quotes. */
  public static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
