package org.hdispatch.app.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.hdispatch.app.draw.Drawing.Anchor;
import org.hdispatch.app.draw.Drawing.Mark;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PixelDrawingTest {
  private static final int BLUE = 0x1f5fa8; // PlotInk.FIRST
  private static final int WHITE = 0xffffff;

  @TempDir Path folder;

  private BufferedImage drawn(PixelDrawing drawing) throws Exception {
    Path file = folder.resolve("a.png");
    drawing.write(file);
    return ImageIO.read(file.toFile());
  }

  private static int at(BufferedImage image, int x, int y) {
    return image.getRGB(3 * x + 1, 3 * y + 1) & 0xffffff;
  }

  private static int inkIn(BufferedImage image, int x0, int x1) {
    int ink = 0;
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 3 * x0; x < 3 * x1; x++) {
        ink += (image.getRGB(x, y) & 0xffffff) == WHITE ? 0 : 1;
      }
    }
    return ink;
  }

  @Test
  void marksAreFullOrOpenWhereTheyAreAskedFor() throws Exception {
    for (Mark mark : new Mark[] {Mark.CIRCLE, Mark.SQUARE, Mark.TRIANGLE, Mark.DIAMOND}) {
      PixelDrawing drawing = new PixelDrawing(60, 30);
      drawing.mark(15, 15, mark, PlotInk.FIRST.light(), true, 1);
      drawing.mark(45, 15, mark, PlotInk.FIRST.light(), false, 1);
      BufferedImage image = drawn(drawing);
      assertEquals(180, image.getWidth());
      assertEquals(90, image.getHeight());
      assertEquals(BLUE, at(image, 15, 15), mark.toString());
      assertEquals(WHITE, at(image, 45, 15), mark.toString());
      assertEquals(WHITE, at(image, 30, 15));
    }
  }

  @Test
  void linesRectanglesAndCrossesAreWhereTheyAreAskedFor() throws Exception {
    PixelDrawing drawing = new PixelDrawing(60, 30);
    drawing.rectangle(0, 0, 10, 10, "#102030");
    drawing.curve(new double[] {20, 50}, new double[] {5.5, 5.5}, PlotInk.FIRST.light(), "");
    drawing.mark(15, 20, Mark.CROSS, PlotInk.FIRST.light(), true, 1);
    drawing.mark(45, 20, Mark.PLUS, PlotInk.FIRST.light(), true, 1);
    BufferedImage image = drawn(drawing);
    assertEquals(0x102030, at(image, 5, 5));
    assertEquals(BLUE, at(image, 35, 5));
    assertEquals(BLUE, at(image, 15, 20));
    assertEquals(WHITE, at(image, 15, 17));
    assertEquals(BLUE, at(image, 45, 20));
    assertEquals(BLUE, at(image, 45, 17));
  }

  @Test
  void dashesLeaveGaps() throws Exception {
    PixelDrawing drawing = new PixelDrawing(60, 10);
    drawing.curve(new double[] {0, 60}, new double[] {5, 5}, PlotInk.FIRST.light(), "10 10");
    BufferedImage image = drawn(drawing);
    assertEquals(BLUE, at(image, 5, 5));
    assertEquals(WHITE, at(image, 15, 5));
    assertEquals(BLUE, at(image, 25, 5));
  }

  @Test
  void textEndsBeginsOrHasItsMiddleWhereItIsAskedFor() throws Exception {
    for (Anchor anchor : Anchor.values()) {
      PixelDrawing drawing = new PixelDrawing(100, 20);
      drawing.text(50, 15, "HMH", anchor, 0);
      BufferedImage image = drawn(drawing);
      int left = inkIn(image, 0, 49);
      int right = inkIn(image, 51, 100);
      assertTrue(left > 20 ^ anchor == Anchor.START, anchor + " " + left);
      assertTrue(right > 20 ^ anchor == Anchor.END, anchor + " " + right);
    }
  }
}
