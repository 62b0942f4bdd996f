package org.hdispatch.app.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hdispatch.app.draw.LogPlot.Scale;
import org.hdispatch.app.text.Numbers;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

class LogPlotTest {
  private static Scale around(double lowest, double highest) {
    return Scale.around("steps", lowest, highest, value -> Numbers.plain(value, 3));
  }

  private static List<Double> bounds(double lowest, double highest) {
    Scale scale = around(lowest, highest);
    return List.of(scale.least(), scale.most());
  }

  @Test
  void axisGoesFromOneTwoOrFiveToTheNext() {
    assertEquals(List.of(20.0, 10_000.0), bounds(30, 6300));
    assertEquals(List.of(0.05, 0.5), bounds(0.0996, 0.499));
    assertEquals(List.of(0.1, 1.0), bounds(0.1, 1));
    assertEquals(List.of(2.0, 5.0), bounds(2, 2)); // never empty
    assertThrows(IllegalArgumentException.class, () -> around(0, 1));
    assertThrows(IllegalArgumentException.class, () -> around(1, Double.POSITIVE_INFINITY));
  }

  @Test
  void longAxisHasPowersOfTenAndAShortOneMore() {
    assertEquals(List.of(100.0, 1000.0, 10_000.0), around(30, 6300).ticks());
    assertEquals(List.of(0.05, 0.1, 0.2, 0.5), around(0.06, 0.4).ticks());
  }

  @Test
  void placesAreLogarithmicAndStayOnTheAxis() {
    Scale scale = around(1, 100);
    assertEquals(0.5, scale.place(10), 1e-12);
    assertEquals(0, scale.place(0));
    assertEquals(0, scale.place(Double.NaN));
    assertEquals(0, scale.place(0.5));
    assertEquals(1, scale.place(1000));
    assertEquals(1, scale.place(Double.POSITIVE_INFINITY));
  }

  @Test
  void curveKeepsItsEndsAndDropsWhatNobodySees() throws Exception {
    LogPlot plot = new LogPlot("t", around(1, 100), around(1, 100));
    double[] many = new double[10_001];
    for (int n = 0; n < many.length; n++) {
      many[n] = 1 + 99.0 * n / 10_000;
    }
    plot.curve(many, many, PlotInk.FIRST, "");
    Document svg = StudyPageTest.parsed(plot.toString());
    Element line = (Element) svg.getElementsByTagName("polyline").item(0);
    String[] points = line.getAttribute("points").split(" ");
    assertTrue(points.length > 100 && points.length < 2000, "points: " + points.length);
    assertEquals("66.0,254.0", points[0]); // the corners of the axes
    assertEquals("396.0,32.0", points[points.length - 1]);
  }

  @Test
  void closeAxisLeavesALittleRoomAndHasMoreNumbers() {
    Scale scale = Scale.close("porosity", 0.1, 0.2, value -> Numbers.plain(value, 3));
    assertEquals(0.1 / 1.1, scale.least(), 1e-12);
    assertEquals(0.2 * 1.1, scale.most(), 1e-12);
    assertEquals(List.of(0.1, 0.12, 0.14, 0.16, 0.18, 0.2), scale.ticks());
    assertEquals(
        List.of(1.0, 1.5, 2.0, 3.0, 4.0, 5.0),
        Scale.close("k", 1, 5, value -> Numbers.plain(value, 3)).ticks());
    assertThrows(IllegalArgumentException.class, () -> Scale.close("k", 0, 5, String::valueOf));
  }

  @Test
  void headingIsSeenAbove() throws Exception {
    LogPlot plot = LogPlot.headed("a heading", around(1, 100), new LinearAxis("y", 5));
    plot.bar(10, 1, 2, PlotInk.FIRST);
    plot.label(10, 2, "a point");
    Document svg = StudyPageTest.parsed(plot.toString());
    Element first = (Element) svg.getElementsByTagName("text").item(0);
    assertEquals("a heading", first.getTextContent());
    assertEquals("320", svg.getDocumentElement().getAttribute("height"));
  }
}
