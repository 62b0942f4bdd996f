package org.hdispatch.app.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class BarPlotTest {
  private static double width(NodeList rectangles, int n) {
    return Double.parseDouble(((Element) rectangles.item(n)).getAttribute("width"));
  }

  @Test
  void partsOfABarAreAsLongAsWhatTheyShow() throws Exception {
    BarPlot.Bar bar = new BarPlot.Bar("b", 10, 10, "20", PlotInk.SECOND);
    BarPlot.Bar half = new BarPlot.Bar("h", 10, 0, "10", PlotInk.FIRST);
    String picture =
        BarPlot.of(
            "t",
            "rest",
            new LinearAxis("us", 20),
            List.of(new BarPlot.Group("g", List.of(bar, half))));
    Document svg = StudyPageTest.parsed(picture);
    NodeList all = svg.getElementsByTagName("rect"); // paper, legend, two parts, one part
    assertEquals(5, all.getLength());
    assertEquals(100, width(all, 2));
    assertEquals(99, width(all, 3)); // a slit of 1 between
    assertEquals(100, width(all, 4));
    assertEquals(PlotInk.SECOND.light(), ((Element) all.item(2)).getAttribute("fill"));
    assertEquals(PlotInk.DARK.light(), ((Element) all.item(3)).getAttribute("fill"));
    assertEquals(PlotInk.FIRST.light(), ((Element) all.item(4)).getAttribute("fill"));
  }
}
