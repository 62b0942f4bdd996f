package org.hdispatch.app.particles;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hdispatch.app.draw.Picture;
import org.hdispatch.porous.io.ImageFileException;

/** Discs on white, y upwards, without text: fonts are what servers lack. */
final class ParticlePicture {
  private static final int LONG_SIDE = 960; // pixels
  private static final int LEAST = 16;
  private static final double DIAMETER = 1.05; // spacings

  private final double spacing;
  private final List<Disc> discs = new ArrayList<>();

  /**
   * An empty picture.
   *
   * @param spacing distance of particles
   */
  ParticlePicture(double spacing) {
    this.spacing = spacing;
  }

  private record Disc(double x, double y, int colour) {}

  /** Adds a particle. */
  void add(double x, double y, int colour) {
    discs.add(new Disc(x, y, colour));
  }

  /** Writes it as PNG; it is whole or not there. */
  void write(Path file) throws ImageFileException {
    Picture.write(file, draw());
  }

  private BufferedImage draw() {
    double left = discs.stream().mapToDouble(Disc::x).min().orElse(0) - spacing;
    double right = discs.stream().mapToDouble(Disc::x).max().orElse(0) + spacing;
    double bottom = discs.stream().mapToDouble(Disc::y).min().orElse(0) - spacing;
    double top = discs.stream().mapToDouble(Disc::y).max().orElse(0) + spacing;
    double pixels = LONG_SIDE / Math.max(right - left, top - bottom); // per unit of length
    BufferedImage image =
        new BufferedImage(
            Math.max(LEAST, (int) Math.ceil((right - left) * pixels)),
            Math.max(LEAST, (int) Math.ceil((top - bottom) * pixels)),
            BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    try {
      graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      graphics.setColor(Color.WHITE);
      graphics.fillRect(0, 0, image.getWidth(), image.getHeight());
      double size = Math.max(1, DIAMETER * spacing * pixels);
      for (Disc each : discs) {
        graphics.setColor(new Color(each.colour()));
        double x = (each.x() - left) * pixels - size / 2;
        double y = (top - each.y()) * pixels - size / 2;
        graphics.fill(new Ellipse2D.Double(x, y, size, size));
      }
    } finally {
      graphics.dispose();
    }
    return image;
  }
}
