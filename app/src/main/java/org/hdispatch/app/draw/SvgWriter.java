package org.hdispatch.app.draw;

import java.util.Locale;

/** Writes the few elements of SVG that plots are made of. */
public final class SvgWriter {
  private static final int SWATCH = 10;
  private static final double LETTER = 7; // width, about

  private final StringBuilder svg = new StringBuilder();

  /**
   * Begins a picture.
   *
   * @param width pixels
   * @param height pixels
   * @param title what it shows, for those who cannot see it
   */
  public SvgWriter(int width, int height, String title) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%1$d\""
                + " height=\"%2$d\" font-family=\"sans-serif\" font-size=\"13\">%n"
                + "<title>%s</title>%n<rect width=\"%1$d\" height=\"%2$d\" fill=\"white\"/>%n",
            width,
            height,
            Markup.escaped(title)));
  }

  /** Where a text has its given place. */
  public enum Anchor {
    START,
    MIDDLE,
    END
  }

  /** A straight line; {@code dashes} as SVG has them, empty for none. */
  public void line(double x1, double y1, double x2, double y2, String colour, String dashes) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"%s/>%n",
            x1,
            y1,
            x2,
            y2,
            colour,
            dashes.isEmpty() ? "" : " stroke-dasharray=\"" + dashes + "\""));
  }

  /** Straight lines from point to point, drawn twice as thick; {@code dashes} as SVG has them. */
  public void curve(double[] x, double[] y, String colour, String dashes) {
    svg.append("<polyline fill=\"none\" stroke-width=\"2\" stroke-linejoin=\"round\" stroke=\"")
        .append(colour)
        .append(dashes.isEmpty() ? "" : "\" stroke-dasharray=\"" + dashes)
        .append("\" points=\"");
    for (int n = 0; n < x.length; n++) {
      svg.append(String.format(Locale.ROOT, "%s%.1f,%.1f", n == 0 ? "" : " ", x[n], y[n]));
    }
    svg.append("\"/>").append(System.lineSeparator());
  }

  /**
   * Upright lines, all in one.
   *
   * @param x places; shape: [lines]
   * @param from upper ends; shape: [lines]
   * @param to lower end of all
   */
  public void ticks(double[] x, double[] from, double to, String colour) {
    svg.append("<path fill=\"none\" stroke=\"").append(colour).append("\" d=\"");
    for (int n = 0; n < x.length; n++) {
      svg.append(String.format(Locale.ROOT, "M%.1f,%.1fV%.1f", x[n], from[n], to));
    }
    svg.append("\"/>").append(System.lineSeparator());
  }

  /** A filled rectangle. */
  public void rectangle(double x, double y, double width, double height, String colour) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>%n",
            x,
            y,
            width,
            height,
            colour));
  }

  /**
   * Says what a colour is.
   *
   * @return where there is room for the next
   */
  public double name(double x, double y, String name, String colour) {
    rectangle(x, y - SWATCH, SWATCH, SWATCH, colour);
    text(x + SWATCH + 5, y, name, Anchor.START, 0);
    return x + SWATCH + 5 + LETTER * name.length() + 14;
  }

  /** What marks a point. */
  public enum Mark {
    CIRCLE,
    SQUARE,
    TRIANGLE,
    DIAMOND
  }

  /** A mark, or its outline if it is not filled. */
  public void mark(double x, double y, Mark mark, String colour, boolean filled) {
    String shape =
        switch (mark) {
          case CIRCLE -> "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\"";
          case SQUARE -> "<path d=\"M%.1f,%.1fm-4,-4h8v8h-8z\"";
          case TRIANGLE -> "<path d=\"M%.1f,%.1fm-5,4h10l-5,-9z\"";
          case DIAMOND -> "<path d=\"M%.1f,%.1fm0,-6l5,6l-5,6l-5,-6z\"";
        };
    svg.append(String.format(Locale.ROOT, shape, x, y))
        .append(" fill=\"" + (filled ? colour : "white") + "\" stroke=\"" + colour + "\"")
        .append(" stroke-width=\"2\"/>")
        .append(System.lineSeparator());
  }

  /** A text, turned by some degrees. */
  public void text(double x, double y, String text, Anchor anchor, int degrees) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>%s</text>%n",
            x,
            y,
            anchor.name().toLowerCase(Locale.ROOT),
            degrees == 0
                ? ""
                : String.format(Locale.ROOT, " transform=\"rotate(%d %.1f %.1f)\"", degrees, x, y),
            Markup.escaped(text)));
  }

  /** The whole picture. */
  @Override
  public String toString() {
    return svg + "</svg>" + System.lineSeparator();
  }
}
