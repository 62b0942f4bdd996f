package org.hdispatch.app.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hdispatch.app.text.Numbers;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

class LanePlotTest {
  private static final PlotAxis SECONDS = new LinearAxis("s", 2);
  private static final PlotAxis MILLIS =
      LogPlot.Scale.decades("ms", 0.5, 30, value -> Numbers.plain(value, 1));

  private static LanePlot plot() {
    return new LanePlot("t", 2, 40, LanePlot.Strips.WITH, SECONDS, MILLIS);
  }

  @Test
  void linesThatFallTogetherAreOneAndTheHighestIsKept() throws Exception {
    LanePlot plot = plot();
    plot.lane("a", "b");
    plot.ticks(new double[] {1, 1.0001, 2}, new double[] {1, 100, 1}, 2, PlotInk.SECOND);
    Document svg = StudyPageTest.parsed(plot.toString());
    Element path = (Element) svg.getElementsByTagName("path").item(0);
    String[] lines = path.getAttribute("d").substring(1).split("M");
    assertEquals(2, lines.length);
    double floor = Double.parseDouble(lines[0].split("V")[1]);
    assertEquals(40, floor - Double.parseDouble(lines[0].split("[,V]")[1]), 0.11); // printed to 0.1
  }

  @Test
  void lanesLieBelowEachOtherWithinThePicture() throws Exception {
    LanePlot plot = plot();
    plot.lane("first", "");
    plot.lane("second", "");
    plot.strip("enduring", new double[0], new double[0], 2, PlotInk.FIRST);
    Document svg = StudyPageTest.parsed(plot.toString());
    double height = Double.parseDouble(svg.getDocumentElement().getAttribute("height"));
    double last = 0;
    for (String name : List.of("first", "second", "enduring", "s")) {
      double at = down(svg, name);
      assertTrue(at > last && at < height, name + ": " + at);
      last = at;
    }
    assertEquals(0, svg.getElementsByTagName("path").getLength());
  }

  private static double down(Document svg, String text) {
    for (int n = 0; ; n++) {
      Element each = (Element) svg.getElementsByTagName("text").item(n);
      if (each.getTextContent().equals(text)) {
        return Double.parseDouble(each.getAttribute("y"));
      }
    }
  }

  @Test
  void histogramIsAnOutlineFromTheFloorToTheFloor() throws Exception {
    LanePlot plot =
        new LanePlot("t", 1, 60, LanePlot.Strips.WITHOUT, SECONDS, new LinearAxis("steps", 10));
    plot.lane("a", "b");
    plot.outline(new double[] {0, 1, 2}, new double[] {10, 5}, PlotInk.FIRST);
    Document svg = StudyPageTest.parsed(plot.toString());
    Element line = (Element) svg.getElementsByTagName("polyline").item(0);
    String[] points = line.getAttribute("points").split(" ");
    assertEquals(6, points.length);
    double floor = Double.parseDouble(points[0].split(",")[1]);
    assertEquals(floor, Double.parseDouble(points[5].split(",")[1]));
    assertEquals(floor - 60, Double.parseDouble(points[1].split(",")[1]));
    assertEquals(floor - 30, Double.parseDouble(points[3].split(",")[1]));
  }

  @Test
  void linearAxisHasReadableTicks() {
    assertEquals(List.of(0.0, 0.5, 1.0, 1.5, 2.0), SECONDS.ticks());
    assertEquals(0.25, SECONDS.place(0.5));
    assertEquals(1, SECONDS.place(9));
    assertEquals(0, SECONDS.place(-1));
  }

  @Test
  void decadesBeginBelowTheLeast() {
    assertEquals(List.of(0.1, 100.0), List.of(MILLIS.least(), MILLIS.most()));
    PlotAxis one = LogPlot.Scale.decades("ms", 1, 1, value -> "");
    assertEquals(List.of(0.1, 1.0), List.of(one.least(), one.most()));
  }
}
