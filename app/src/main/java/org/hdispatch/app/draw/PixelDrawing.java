package org.hdispatch.app.draw;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Arrays;
import org.hdispatch.porous.io.ImageFileException;

/**
 * Draws plots as pixels, to be written as PNG. Text is drawn in strokes of our own, so that it
 * needs no fonts on the machine.
 */
public final class PixelDrawing implements Drawing {
  /** Pixels of the picture to a pixel of the plot. */
  private static final int SCALE = 3;

  private static final double TEXT = 13; // as in SVG
  private static final float PEN = 1.15f; // of text

  private final BufferedImage image;
  private final Graphics2D graphics;

  /**
   * Begins a picture.
   *
   * @param width pixels of the plot; the picture has three times as many
   * @param height likewise
   */
  public PixelDrawing(int width, int height) {
    image = new BufferedImage(width * SCALE, height * SCALE, BufferedImage.TYPE_INT_RGB);
    graphics = image.createGraphics();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    graphics.scale(SCALE, SCALE);
    rectangle(0, 0, width, height, PlotInk.PAPER.light());
  }

  private static Color colour(String name) {
    return name.equals("white") ? Color.WHITE : Color.decode(name);
  }

  private void stroke(Shape shape, String colour, float width, String dashes) {
    graphics.setColor(colour(colour));
    graphics.setStroke(
        dashes.isEmpty()
            ? new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND)
            : new BasicStroke(
                width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, lengths(dashes), 0));
    graphics.draw(shape);
  }

  private static float[] lengths(String dashes) {
    double[] each = Arrays.stream(dashes.split(" ")).mapToDouble(Double::parseDouble).toArray();
    float[] lengths = new float[each.length];
    for (int n = 0; n < each.length; n++) {
      lengths[n] = (float) each[n];
    }
    return lengths;
  }

  @Override
  public void line(double x1, double y1, double x2, double y2, String colour, String dashes) {
    stroke(new Line2D.Double(x1, y1, x2, y2), colour, 1, dashes);
  }

  @Override
  public void curve(double[] x, double[] y, String colour, String dashes) {
    Path2D path = new Path2D.Double();
    path.moveTo(x[0], y[0]);
    for (int n = 1; n < x.length; n++) {
      path.lineTo(x[n], y[n]);
    }
    stroke(path, colour, 2, dashes);
  }

  @Override
  public void rectangle(double x, double y, double width, double height, String colour) {
    graphics.setColor(colour(colour));
    graphics.fill(new Rectangle2D.Double(x, y, width, height));
  }

  @Override
  public void mark(double x, double y, Mark mark, String colour, boolean filled, double size) {
    Path2D path = new Path2D.Double();
    switch (mark) {
      case CIRCLE -> path.append(new Ellipse2D.Double(-4, -4, 8, 8), false);
      case SQUARE -> path.append(new Rectangle2D.Double(-4, -4, 8, 8), false);
      case TRIANGLE -> polygon(path, -5, 4, 5, 4, 0, -5);
      case DIAMOND -> polygon(path, 0, -6, 5, 0, 0, 6, -5, 0);
      case CROSS -> {
        path.append(new Line2D.Double(-4, -4, 4, 4), false);
        path.append(new Line2D.Double(4, -4, -4, 4), false);
      }
      case PLUS -> {
        path.append(new Line2D.Double(-5, 0, 5, 0), false);
        path.append(new Line2D.Double(0, -5, 0, 5), false);
      }
    }
    AffineTransform there = AffineTransform.getTranslateInstance(x, y);
    there.scale(size, size);
    Shape shape = there.createTransformedShape(path);
    graphics.setColor(filled ? colour(colour) : Color.WHITE);
    graphics.fill(shape);
    stroke(shape, colour, size < 1 ? 1.2f : 2, "");
  }

  private static void polygon(Path2D path, double... points) {
    path.moveTo(points[0], points[1]);
    for (int n = 2; n < points.length; n += 2) {
      path.lineTo(points[n], points[n + 1]);
    }
    path.closePath();
  }

  @Override
  public void text(double x, double y, String text, Anchor anchor, int degrees) {
    double width = StrokeFont.width(text, TEXT);
    double from =
        switch (anchor) {
          case START -> x;
          case MIDDLE -> x - width / 2;
          case END -> x - width;
        };
    Shape strokes =
        AffineTransform.getRotateInstance(Math.toRadians(degrees), x, y)
            .createTransformedShape(StrokeFont.strokes(text, from, y, TEXT));
    graphics.setColor(Color.BLACK);
    graphics.setStroke(new BasicStroke(PEN, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    graphics.draw(strokes);
  }

  /** Writes what has been drawn as PNG; it is whole or not there. Nothing can be drawn after it. */
  public void write(Path file) throws ImageFileException {
    graphics.dispose();
    Picture.write(file, image);
  }
}
