package org.hdispatch.app.draw;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.Channels;
import java.nio.file.Path;
import java.util.function.IntUnaryOperator;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.WholeFiles;

/**
 * Draws planes of voxels as PNG, without text: fonts are what servers lack. A small plane is drawn
 * with several pixels a voxel.
 */
public final class Picture {
  private static final int LEAST_PIXELS = 480;

  private Picture() {}

  /**
   * Writes a picture; it is whole or not there.
   *
   * @param colour colour (0xRRGGBB) of a voxel by its flat place
   */
  public static void write(Path file, Plane plane, IntUnaryOperator colour)
      throws ImageFileException {
    write(file, draw(plane, colour));
  }

  /** Writes an image as PNG; it is whole or not there. */
  public static void write(Path file, BufferedImage image) throws ImageFileException {
    WholeFiles.write(
        file,
        channel -> {
          try (ImageOutputStream out =
              new MemoryCacheImageOutputStream(Channels.newOutputStream(channel))) {
            if (!ImageIO.write(image, "png", out)) {
              throw new IOException("this Java writes no PNG");
            }
          }
        });
  }

  /** An image as the bytes of a PNG file. */
  public static byte[] png(BufferedImage image) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      if (!ImageIO.write(image, "png", stream)) {
        throw new IOException("this Java writes no PNG");
      }
    } catch (IOException e) {
      throw new UncheckedIOException("picture must be drawn", e);
    }
    return out.toByteArray();
  }

  private static BufferedImage draw(Plane plane, IntUnaryOperator colour) {
    int pixels = Math.max(1, LEAST_PIXELS / Math.max(plane.width(), plane.height()));
    BufferedImage image =
        new BufferedImage(
            plane.width() * pixels, plane.height() * pixels, BufferedImage.TYPE_INT_RGB);
    for (int row = 0; row < image.getHeight(); row++) {
      for (int column = 0; column < image.getWidth(); column++) {
        image.setRGB(column, row, colour.applyAsInt(plane.voxel(column / pixels, row / pixels)));
      }
    }
    return image;
  }
}
