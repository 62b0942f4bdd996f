package org.hdispatch.app.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.StringReader;
import java.util.Collections;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

public class StudyPageTest {
  /** A page as XML. */
  public static Document parsed(String page) throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new InputSource(new StringReader(page)));
  }

  private static String only(Document page, String tag) {
    NodeList all = page.getElementsByTagName(tag);
    assertEquals(1, all.getLength(), tag);
    return all.item(0).getTextContent();
  }

  @Test
  void pageIsWellFormedWhateverItsTextsAre() throws Exception {
    String odd = "a < b & \"c\" > d";
    Document page =
        parsed(
            new StudyPage(odd, odd)
                .section(odd)
                .paragraph("5 % of 3 s are 1 person")
                .verdict(List.of(odd))
                .points(List.of(odd, odd))
                .table(odd, List.of("<x>", "y"), List.of(List.of("1", "2"), List.of("", "3")))
                .figure(odd, List.of(new SvgWriter(9, 9, odd).toString()))
                .command("a && b")
                .files(List.of("x&y.csv"))
                .toString());
    assertEquals("html", page.getDocumentElement().getTagName());
    for (String tag : List.of("h1", "h2", "figcaption")) {
      assertEquals(odd, only(page, tag));
    }
    assertEquals("a && b", only(page, "pre"));
    assertEquals(3, page.getElementsByTagName("li").getLength() - 1); // and one file
    assertEquals(4, page.getElementsByTagName("td").getLength());
    assertEquals(1, page.getElementsByTagName("svg").getLength());
    Element link = (Element) page.getElementsByTagName("a").item(0);
    assertEquals("x&y.csv", link.getAttribute("href"));
    Element below = (Element) page.getElementsByTagName("tr").item(2);
    assertEquals("more", below.getAttribute("class"));
  }

  @Test
  void lineEndsBetweenNoNumberAndItsUnit() throws Exception {
    Document page = parsed(new StudyPage("t", "5 % of 3 s, 4 x 2 steps, 6 us, 7 KiB").toString());
    assertEquals("5\u00a0% of 3\u00a0s, 4\u00a0x 2 steps, 6\u00a0us, 7\u00a0KiB", only(page, "p"));
  }

  @Test
  void shortRowsAreHeadingsAndRemarks() throws Exception {
    List<List<String>> rows =
        List.of(List.of("part"), List.of("1", "gone"), List.of("1", "2", "3"));
    Document page =
        parsed(new StudyPage("t", "l").table("c", List.of("x", "y", "z"), rows).toString());
    Element part = (Element) page.getElementsByTagName("tr").item(1);
    assertEquals("part", part.getAttribute("class"));
    assertEquals("3", ((Element) part.getFirstChild()).getAttribute("colspan"));
    Element note = (Element) page.getElementsByTagName("td").item(1);
    assertEquals("gone", note.getTextContent());
    assertEquals("2", note.getAttribute("colspan"));
    assertEquals(5, page.getElementsByTagName("td").getLength());
  }

  @Test
  void tableOfManyColumnsTurnsThePaper() {
    List<String> head = Collections.nCopies(13, "x");
    String many = new StudyPage("t", "l").table("c", head, List.of(head)).toString();
    assertTrue(many.contains("<div class=\"wide sheet\">"), many);
    List<String> less = head.subList(1, 13);
    String few = new StudyPage("t", "l").table("c", less, List.of(less)).toString();
    assertTrue(few.contains("<div class=\"wide\">"), few);
  }

  @Test
  void pageNeedsNothingElse() {
    String page = new StudyPage("t", "l").toString();
    for (String what : List.of("<script", "http:", "https:", "@import", "url(")) {
      assertFalse(page.contains(what), what);
    }
  }

  @Test
  void picturesAreDrawnInTheDarkToo() {
    String page = new StudyPage("t", "l").toString();
    assertTrue(page.contains("prefers-color-scheme: dark"));
    for (PlotInk ink : PlotInk.values()) {
      for (String what : List.of("fill", "stroke")) {
        String rule = what + "=\"" + ink.light() + "\"] { " + what + ": " + ink.dark() + "; }";
        assertTrue(page.contains(rule), rule);
      }
    }
  }

  @Test
  void photosArePartOfThePage() throws Exception {
    byte[] png = {1, 2, 3};
    Document page =
        parsed(
            new StudyPage("t", "l")
                .photos("c", List.of(new StudyPage.Photo(png, "a < b")))
                .toString());
    Element image = (Element) page.getElementsByTagName("img").item(0);
    assertEquals("data:image/png;base64,AQID", image.getAttribute("src"));
    assertEquals("a < b", image.getAttribute("alt"));
    assertTrue(only(page, "figcaption").equals("c"));
  }
}
