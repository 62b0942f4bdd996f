package org.hdispatch.app.study.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.hdispatch.app.draw.PlotInk;
import org.hdispatch.app.draw.StudyPageTest;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcFigures;
import org.hdispatch.app.study.GcFigures.StepTimes;
import org.hdispatch.app.study.GcFigures.Stops;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.GcRows;
import org.hdispatch.app.study.ScratchPolicy;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class GcPageTest {
  private static final List<GcRow> STUDY = GcSamples.study();

  /** A page as XML, which says nothing that is no number or not there. */
  private static Document page(List<GcRow> rows) throws Exception {
    String html = GcPage.html(rows, "./hdispatch gc-study --output a && b", List.of("a.csv"));
    for (String bad : List.of("NaN", "null", "Infinity", "unknown", "Optional")) {
      assertFalse(html.contains(bad), bad);
    }
    return StudyPageTest.parsed(html);
  }

  private static List<Element> all(Document page, String tag) {
    NodeList nodes = page.getElementsByTagName(tag);
    return IntStream.range(0, nodes.getLength()).mapToObj(n -> (Element) nodes.item(n)).toList();
  }

  private static long count(Document page, String tag, String text) {
    return all(page, tag).stream().filter(e -> e.getTextContent().equals(text)).count();
  }

  /** Rows of tables that are neither heads nor headings. */
  private static long runs(Document page) {
    return all(page, "tr").stream()
        .filter(row -> row.getElementsByTagName("td").getLength() > 0)
        .count();
  }

  private static List<GcRow> some(Collector collector, String java) {
    return STUDY.stream()
        .filter(row -> row.of().collector() == collector && row.of().java().equals(java))
        .toList();
  }

  @Test
  void pageHasEveryRowAndEveryPicture() throws Exception {
    Document page = page(STUDY);
    assertEquals(STUDY.size(), runs(page));
    assertEquals(4, count(page, "td", "no figures: out of memory: Java heap space"));
    assertEquals(4 + 4 + 4 + 1, all(page, "svg").size()); // bars, pauses, steps; bars of 1 MiB
    assertEquals(
        List.of(
            "Verdict",
            "Processor time",
            "Pauses",
            "Step times",
            "Other work, other sizes of scratch",
            "All runs",
            "How it was measured",
            "Do it again",
            "Sources"),
        all(page, "h2").stream().map(Element::getTextContent).toList());
    assertEquals(1, count(page, "pre", "./hdispatch gc-study --output a && b"));
  }

  @Test
  void tableShowsWhatWasMeasured() throws Exception {
    Document page = page(some(Collector.ZGC, GcSamples.NEW));
    Element row =
        all(page, "tr").stream()
            .filter(each -> each.getTextContent().startsWith("ZGC, per cell"))
            .findFirst()
            .orElseThrow();
    NodeList cells = row.getElementsByTagName("td");
    List<String> texts =
        IntStream.range(0, cells.getLength())
            .mapToObj(n -> cells.item(n).getTextContent())
            .toList();
    assertEquals(GcTable.HEAD.size(), texts.size());
    assertEquals(List.of("39.4", "2.3", "1.73", "1.53", "1.54", "62", "1.2"), texts.subList(2, 9));
    assertEquals(List.of("187", "18.7", "21", "126"), texts.subList(11, 15));
    assertEquals("356 / 396", texts.get(20));
  }

  @Test
  void pauseIsALineAndEnduringScratchHasNone() throws Exception {
    Document page = page(some(Collector.G1, GcSamples.OLD));
    List<Element> lines = all(page, "path"); // per cell, in two heaps
    assertEquals(2, lines.size());
    for (Element each : lines) {
      assertEquals(PlotInk.SECOND.light(), each.getAttribute("stroke"));
    }
    assertEquals(11, lines.get(0).getAttribute("d").split("M").length - 1);
    assertEquals(1, count(page, "text", "11 pauses, 42 ms; longest 6 ms"));
  }

  @Test
  void pageDoesWithLess() throws Exception {
    List<GcRow> oneJava =
        STUDY.stream().filter(row -> row.of().java().equals(GcSamples.OLD)).toList();
    List<GcRow> quick =
        oneJava.stream()
            .filter(row -> row.of().policy() != ScratchPolicy.PER_STEP)
            .filter(row -> row.of().heapFactor() == 6)
            .toList();
    for (List<GcRow> rows : List.of(oneJava, quick)) {
      assertEquals(rows.size(), runs(page(rows)));
    }
    for (GcRow row : STUDY) {
      assertEquals(1, runs(page(List.of(row))));
    }
  }

  @Test
  void pageOfDeadRunsHasTheirReasonsAndNoPicture() throws Exception {
    List<GcRow> dead = STUDY.stream().filter(row -> row.figures().isEmpty()).toList();
    Document page = page(dead);
    assertEquals(dead.size(), runs(page));
    assertTrue(all(page, "svg").isEmpty());
  }

  @Test
  void whatNobodyMeasuredIsADash() throws Exception {
    Stops not = new Stops(-1, 0, 0, 0);
    GcCase of = GcSamples.of(GcSamples.OLD, Collector.SHENANDOAH, ScratchPolicy.PER_CELL, 2);
    GcRow row = GcSamples.collecting(of, 30, 4, 3, not, not, not, -1);
    Document page = page(List.of(row));
    // over enduring; 3 of pauses; stopped and reaching; stalls and their sum; p99 and p99.9 of
    // few steps; bytes
    assertEquals(11, count(page, "td", "\u2013"));
    assertEquals(1, count(page, "text", "pauses not measured"));
  }

  @Test
  void pageOfSeveralRunsHasEachAndSaysHowMany() throws Exception {
    List<GcRow> rows = new ArrayList<>(some(Collector.G1, GcSamples.OLD));
    some(Collector.G1, GcSamples.OLD).forEach(row -> rows.add(GcRows.again(row, 2)));
    Document page = page(rows);
    assertEquals(rows.size(), runs(page));
    assertEquals(2, count(page, "td", "G1, per cell, run 2")); // two heaps
    String text = page.getDocumentElement().getTextContent();
    assertTrue(text.contains(rows.size() + " runs, 2 of each case."), text);
    assertTrue(text.contains("JVMs a case: 2, in rounds"), text);
    assertFalse(text.contains("One JVM a case"), text);
    assertTrue(page(STUDY).getDocumentElement().getTextContent().contains("One JVM a case"));
  }

  @Test
  void pageSaysWhatItsRowsWereMadeWith() throws Exception {
    String text = page(STUDY).getDocumentElement().getTextContent().replace('\u00a0', ' ');
    assertTrue(text.contains("Machine: processor of 2 GHz, 2 cores, 8 GiB, Linux 6, amd64."), text);
    assertTrue(text.contains("JVM: 17.0.15+6 of Maker. Hash of the code that ran: c0de."), text);
  }

  @Test
  void runWithoutAStepHasNoFigures() throws Exception {
    GcCase of = GcSamples.of(GcSamples.OLD, Collector.G1, ScratchPolicy.PER_CELL, 2);
    Stops none = GcSamples.stops(0, 0, 0);
    StepTimes times = new StepTimes(0, 0, 0, 0, List.of(), List.of());
    GcFigures empty =
        new GcFigures(1, 1, 2, 9, 0, 0, 0, 0, 0, 0, none, none, 0, none, times, 0, 0, List.of());
    Document page = page(List.of(GcRows.first(of, "", Optional.of(empty))));
    assertEquals(1, count(page, "td", "no figures: it did not finish a step"));
  }
}
