package org.hdispatch.app.draw;

import java.awt.geom.Path2D;
import java.util.Map;

/**
 * Letters drawn with a pen of constant width, as plotters did. They need no font files, which
 * servers lack. Letters it does not know are a box.
 *
 * <p>A letter is its width in units, a colon, and strokes parted by semicolons. A stroke is points:
 * a digit to the right, a letter upwards, where {@code c} is the base line, {@code h} the height of
 * small letters and {@code j} that of capitals. A stroke that begins with {@code ~} is round: the
 * points between its ends pull it towards them (quadratic splines); if it ends where it began, all
 * of them do. A stroke of one point is a dot.
 */
final class StrokeFont {
  private static final double UNITS_PER_SIZE = 9.6; // a capital is 7 units high
  private static final double NARROW = 0.86; // units to the right are less wide than high
  private static final double GAP = 1.9; // between letters, units
  private static final double BLANK = 2.2;
  private static final String UNKNOWN = "3:0c3c3j0j0c";

  private static final Map<String, String> GLYPHS =
      Map.ofEntries(
          Map.entry("0", "4:~0j4j4c0c0j"),
          Map.entry("1", "3:0h2j2c"),
          Map.entry("2", "4:~0i1j4j4g0c;0c4c"),
          Map.entry("3", "4:~0i1j4j4g2g;~2g4g4c1c0d"),
          Map.entry("4", "4:3c3j0e4e"),
          Map.entry("5", "4:4j0j0f;~0f1g4g4c1c0d"),
          Map.entry("6", "4:~4i3j0j0e0c4c4g1g0e"),
          Map.entry("7", "4:0j4j1c"),
          Map.entry("8", "4:~0j4j4g0g0j;~0g4g4c0c0g"),
          Map.entry("9", "4:~0d1c4c4h4j0j0f3f4h"),
          Map.entry("A", "4:0c2j4c;1f3f"),
          Map.entry("B", "4:0c0j;~0j4j4g0g;~0g5g5c0c"),
          Map.entry("C", "4:~4i3j0j0c3c4d"),
          Map.entry("D", "4:0c0j;~0j2j4j4c2c0c"),
          Map.entry("E", "4:4j0j0c4c;0g3g"),
          Map.entry("F", "4:4j0j0c;0g3g"),
          Map.entry("G", "5:~5i4j0j0c4c5d;5d5f3f"),
          Map.entry("H", "4:0c0j;4c4j;0g4g"),
          Map.entry("I", "0:0c0j"),
          Map.entry("J", "3:3j3e;~3e3c0c0e"),
          Map.entry("K", "4:0c0j;4j0f;1g4c"),
          Map.entry("L", "3:0j0c3c"),
          Map.entry("M", "6:0c0j3e6j6c"),
          Map.entry("N", "4:0c0j4c4j"),
          Map.entry("O", "5:~0j5j5c0c0j"),
          Map.entry("P", "4:0c0j;~0j4j4f0f"),
          Map.entry("Q", "5:~0j5j5c0c0j;3e5b"),
          Map.entry("R", "4:0c0j;~0j4j4f0f;2f4c"),
          Map.entry("S", "4:~4i3j0j0g4g4c1c0d"),
          Map.entry("T", "4:0j4j;2j2c"),
          Map.entry("U", "4:0j0e;~0e0c4c4e;4e4j"),
          Map.entry("V", "4:0j2c4j"),
          Map.entry("W", "6:0j1c3i5c6j"),
          Map.entry("X", "4:0c4j;0j4c"),
          Map.entry("Y", "4:0j2f4j;2f2c"),
          Map.entry("Z", "4:0j4j0c4c"),
          Map.entry("a", "3:~0h3h3c0c0h;3h3c"),
          Map.entry("b", "3:0j0c;~0h3h3c0c0h"),
          Map.entry("c", "3:~3g2h0h0c2c3d"),
          Map.entry("d", "3:3j3c;~0h3h3c0c0h"),
          Map.entry("e", "3:0f3f;~3f3h0h0c2c3d"),
          Map.entry("f", "2:~2j1j1i;1i1c;0h2h"),
          Map.entry("g", "3:~0h3h3c0c0h;3h3c;~3c3a1a0b"),
          Map.entry("h", "3:0j0c;~0f0h3h3e;3e3c"),
          Map.entry("i", "0:0h0c;0j"),
          Map.entry("j", "1:1h1b;~1b1a0a;1j"),
          Map.entry("k", "3:0j0c;3h0e;1f3c"),
          Map.entry("l", "0:0j0c"),
          Map.entry("m", "6:0h0c;~0f0h3h3e;3e3c;~3f3h6h6e;6e6c"),
          Map.entry("n", "3:0h0c;~0f0h3h3e;3e3c"),
          Map.entry("o", "3:~0h3h3c0c0h"),
          Map.entry("p", "3:0h0a;~0h3h3c0c0h"),
          Map.entry("q", "3:3h3a;~0h3h3c0c0h"),
          Map.entry("r", "2:0h0c;~0f0h2h"),
          Map.entry("s", "3:~3g2h0h0f3f3c1c0d"),
          Map.entry("t", "2:1j1d;~1d1c2c;0h2h"),
          Map.entry("u", "3:0h0e;~0e0c3c3f;3h3c"),
          Map.entry("v", "4:0h2c4h"),
          Map.entry("w", "6:0h1c3g5c6h"),
          Map.entry("x", "3:0c3h;0h3c"),
          Map.entry("y", "4:0h2c;4h2c1a"),
          Map.entry("z", "3:0h3h0c3c"),
          Map.entry(".", "0:0c"),
          Map.entry(",", "1:1c0b"),
          Map.entry(":", "0:0c;0g"),
          Map.entry(";", "1:1c0b;1g"),
          Map.entry("-", "3:0f3f"),
          Map.entry("\u2013", "4:0f4f"),
          Map.entry("+", "4:0f4f;2d2h"),
          Map.entry("\u00b1", "4:0g4g;2e2i;0c4c"),
          Map.entry("=", "4:0e4e;0g4g"),
          Map.entry("<", "4:4h0f4d"),
          Map.entry(">", "4:0h4f0d"),
          Map.entry("(", "2:~2j0i0b2a"),
          Map.entry(")", "2:~0j2i2b0a"),
          Map.entry("[", "2:2j0j0a2a"),
          Map.entry("]", "2:0j2j2a0a"),
          Map.entry("/", "3:0b3j"),
          Map.entry("_", "4:0b4b"),
          Map.entry("'", "0:0j0h"),
          Map.entry("\"", "2:0j0h;2j2h"),
          Map.entry("*", "4:0f4f;1d3h;1h3d"),
          Map.entry("!", "0:0j0e;0c"),
          Map.entry("?", "3:~0i0j3j3g1g1e;1c"),
          Map.entry("%", "5:0c5j;~0j2j2h0h0j;~3e5e5c3c3e"),
          Map.entry("&", "5:~5f4c0c0f4h3j1j0h2f;2f5c"),
          Map.entry("^", "2:0h1j2h"),
          Map.entry("\u00b2", "2:~0i0j2j2i0g;0g2g"),
          Map.entry("\u00b3", "2:0j2j1i;~1i2i2g0g"),
          Map.entry("\u00b5", "3:0h0a;~0e0c3c3f;3h3c"),
          Map.entry("\u00b7", "0:0f"),
          Map.entry("\u00d7", "4:0d4h;0h4d"));

  private StrokeFont() {}

  private static String glyph(String letter) {
    return GLYPHS.getOrDefault(letter, UNKNOWN);
  }

  /** Width of a text, from its first stroke to its last. */
  static double width(String text, double size) {
    double units = 0;
    for (int n = 0; n < text.length(); n++) {
      units += advance(text.substring(n, n + 1));
    }
    return Math.max(0, units - GAP) * NARROW * size / UNITS_PER_SIZE;
  }

  private static double advance(String letter) {
    return letter.equals(" ") ? BLANK + GAP : glyph(letter).charAt(0) - '0' + GAP;
  }

  /**
   * The strokes of a text, to be drawn with a pen that has round ends.
   *
   * @param x where it begins
   * @param y its base line, counted downwards
   * @param size as that of a font
   */
  static Path2D strokes(String text, double x, double y, double size) {
    Path2D path = new Path2D.Double();
    double unit = size / UNITS_PER_SIZE;
    double units = 0;
    for (int n = 0; n < text.length(); n++) {
      String letter = text.substring(n, n + 1);
      if (!letter.equals(" ")) {
        for (String stroke : glyph(letter).substring(2).split(";")) {
          add(path, stroke, x + units * NARROW * unit, y, unit);
        }
      }
      units += advance(letter);
    }
    return path;
  }

  private static void add(Path2D path, String stroke, double x, double y, double unit) {
    boolean round = stroke.startsWith("~");
    String points = round ? stroke.substring(1) : stroke;
    int count = points.length() / 2;
    double[] px = new double[count];
    double[] py = new double[count];
    for (int n = 0; n < count; n++) {
      px[n] = x + (points.charAt(2 * n) - '0') * NARROW * unit;
      py[n] = y - (points.charAt(2 * n + 1) - 'c') * unit;
    }
    if (count == 1) {
      path.moveTo(px[0], py[0]);
      path.lineTo(px[0], py[0] - unit / 8);
    } else if (!round) {
      path.moveTo(px[0], py[0]);
      for (int n = 1; n < count; n++) {
        path.lineTo(px[n], py[n]);
      }
    } else if (px[0] == px[count - 1] && py[0] == py[count - 1]) {
      path.moveTo((px[0] + px[1]) / 2, (py[0] + py[1]) / 2);
      for (int n = 1; n < count; n++) {
        int next = n == count - 1 ? 1 : n + 1; // the last point is the first again
        path.quadTo(px[n], py[n], (px[n] + px[next]) / 2, (py[n] + py[next]) / 2);
      }
    } else {
      path.moveTo(px[0], py[0]);
      for (int n = 1; n < count - 2; n++) {
        path.quadTo(px[n], py[n], (px[n] + px[n + 1]) / 2, (py[n] + py[n + 1]) / 2);
      }
      path.quadTo(px[count - 2], py[count - 2], px[count - 1], py[count - 1]);
    }
  }
}
