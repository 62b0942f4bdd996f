package org.hdispatch.app;

/** What HTML and SVG have in common. */
final class Markup {
  private Markup() {}

  /** A text as it may stand between tags, or between double quotes. */
  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
