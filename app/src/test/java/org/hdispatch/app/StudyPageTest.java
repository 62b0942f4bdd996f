package org.hdispatch.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.StringReader;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

class StudyPageTest {
  /** A page as XML. */
  static Document parsed(String page) throws Exception {
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
    Document page = parsed(new StudyPage("t", "5 % of 3 s, 4 x 2 steps").toString());
    assertEquals("5\u00a0% of 3\u00a0s, 4\u00a0x 2 steps", only(page, "p"));
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
}
