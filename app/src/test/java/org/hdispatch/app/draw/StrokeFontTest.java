package org.hdispatch.app.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class StrokeFontTest {
  private static final double SIZE = 9.6; // a unit is a pixel

  private static Rectangle2D bounds(String text) {
    return StrokeFont.strokes(text, 0, 0, SIZE).getBounds2D();
  }

  /** The path as numbers. */
  private static List<String> path(String text) {
    Path2D path = StrokeFont.strokes(text, 0, 0, SIZE);
    List<String> parts = new ArrayList<>();
    for (PathIterator at = path.getPathIterator(null); !at.isDone(); at.next()) {
      double[] points = new double[6];
      parts.add(at.currentSegment(points) + Arrays.toString(points));
    }
    return parts;
  }

  @Test
  void everyPrintableLetterThatFiguresUseHasAShapeOfItsOwn() {
    List<String> seen = new ArrayList<>(List.of(path("\u4e2d").toString())); // the box
    String letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
            + ".,:;-+=<>()[]/_'\"*!?%&^\u2013\u00b1\u00b2\u00b3\u00b5\u00b7\u00d7";
    for (String letter : letters.split("")) {
      String shape = path(letter).toString();
      assertFalse(seen.contains(shape) && !letter.equals("l"), letter); // l is like I
      seen.add(shape);
    }
  }

  @Test
  void capitalsStandOnTheLineAndTailsHangBelow() {
    assertEquals(-7, bounds("H").getMinY(), 1e-9);
    assertEquals(0, bounds("H").getMaxY(), 1e-9);
    assertEquals(-5, bounds("x").getMinY(), 1e-9);
    assertTrue(bounds("p").getMaxY() > 1.9);
  }

  @Test
  void textIsAsWideAsItsStrokesReach() {
    for (String text : List.of("H", "HM", "x z", "l")) {
      Rectangle2D strokes = bounds(text);
      assertEquals(strokes.getMaxX(), StrokeFont.width(text, SIZE), 1e-9, text);
    }
    assertEquals(0, StrokeFont.width("", SIZE));
    assertEquals(2 * StrokeFont.width("HM", SIZE), StrokeFont.width("HM", 2 * SIZE), 1e-9);
  }

  @Test
  void roundStrokesThatCloseTouchTheMiddlesOfTheirSides() {
    Rectangle2D o = bounds("o");
    assertEquals(0, o.getMinX(), 1e-9);
    assertEquals(-5, o.getMinY(), 1e-9);
    assertEquals(0, o.getMaxY(), 1e-9);
  }
}
