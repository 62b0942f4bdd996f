package org.hdispatch.app.draw;

/**
 * What plots are drawn on: an SVG, or pixels. Places are in pixels from the upper left; colours as
 * those of {@link PlotInk}, or {@code #rrggbb}.
 */
public interface Drawing {
  /** Edge of the square that says what a colour is. */
  int SWATCH = 10;

  /** Width of a letter, about. */
  double LETTER = 7;

  /** Where a text has its given place. */
  enum Anchor {
    START,
    MIDDLE,
    END
  }

  /** What marks a point. */
  enum Mark {
    CIRCLE,
    SQUARE,
    TRIANGLE,
    DIAMOND,
    CROSS,
    PLUS
  }

  /** A straight line; {@code dashes} as SVG has them, empty for none. */
  void line(double x1, double y1, double x2, double y2, String colour, String dashes);

  /** Straight lines from point to point, drawn twice as thick; {@code dashes} as SVG has them. */
  void curve(double[] x, double[] y, String colour, String dashes);

  /** A filled rectangle. */
  void rectangle(double x, double y, double width, double height, String colour);

  /**
   * A mark, or its outline if it is not filled.
   *
   * @param size times the usual one
   */
  void mark(double x, double y, Mark mark, String colour, boolean filled, double size);

  /** A text, turned by some degrees. */
  void text(double x, double y, String text, Anchor anchor, int degrees);

  /**
   * Says what a colour is.
   *
   * @return where there is room for the next
   */
  default double name(double x, double y, String name, String colour) {
    rectangle(x, y - SWATCH, SWATCH, SWATCH, colour);
    text(x + SWATCH + 5, y, name, Anchor.START, 0);
    return x + SWATCH + 5 + LETTER * name.length() + 14;
  }
}
