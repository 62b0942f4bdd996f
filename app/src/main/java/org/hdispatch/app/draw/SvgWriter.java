package org.hdispatch.app.draw;

import java.util.Locale;

/** Writes the few elements of SVG that plots are made of. */
public final class SvgWriter implements Drawing {
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

  @Override
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

  @Override
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

  @Override
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

  /** A mark of the usual size. */
  public void mark(double x, double y, Mark mark, String colour, boolean filled) {
    mark(x, y, mark, colour, filled, 1);
  }

  @Override
  public void mark(double x, double y, Mark mark, String colour, boolean filled, double size) {
    svg.append(
        switch (mark) {
          case CIRCLE -> format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%s\"", x, y, plain(4 * size));
          case SQUARE -> path("M%.1f,%.1fm%s,%sh%sv%sh%sz", x, y, size, -4, -4, 8, 8, -8);
          case TRIANGLE -> path("M%.1f,%.1fm%s,%sh%sl%s,%sz", x, y, size, -5, 4, 10, -5, -9);
          case DIAMOND ->
              path("M%.1f,%.1fm%s,%sl%s,%sl%s,%sl%s,%sz", x, y, size, 0, -6, 5, 6, -5, 6, -5, -6);
          case CROSS ->
              path("M%.1f,%.1fm%s,%sl%s,%sm%s,%sl%s,%s", x, y, size, -4, -4, 8, 8, 0, -8, -8, 8);
          case PLUS -> path("M%.1f,%.1fm%s,%sh%sm%s,%sv%s", x, y, size, -5, 0, 10, -5, -5, 10);
        });
    svg.append(" fill=\"" + (filled ? colour : "white") + "\" stroke=\"" + colour + "\"")
        .append(" stroke-width=\"" + (size < 1 ? "1.2" : "2") + "\"/>")
        .append(System.lineSeparator());
  }

  private static String format(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }

  private static String path(String format, double x, double y, double size, int... moves) {
    Object[] values = new Object[2 + moves.length];
    values[0] = x;
    values[1] = y;
    for (int n = 0; n < moves.length; n++) {
      values[2 + n] = plain(size * moves[n]);
    }
    return "<path d=\"" + format(format, values) + "\"";
  }

  private static String plain(double value) {
    return value == Math.rint(value) ? format("%.0f", value) : format("%.1f", value);
  }

  @Override
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
