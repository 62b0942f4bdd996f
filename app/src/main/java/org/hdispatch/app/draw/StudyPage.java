package org.hdispatch.app.draw;

import java.util.Base64;
import java.util.List;
import java.util.regex.Pattern;

/**
 * A page about a study: HTML in one file, without scripts and without anything to be fetched, for
 * large screens, phones and paper, in the light and in the dark. It is well-formed XML too.
 *
 * <p>Pictures are drawn in the colours of {@link PlotInk}; in the dark the page draws them in its
 * dark ones.
 */
public final class StudyPage {
  private static final String STYLE =
      """
      :root { color-scheme: light dark; --paper: #ffffff; --ink: #1d2126; --soft: #5a636d;
        --line: #d5d9de; --wash: #f3f5f7; --accent: #1f5fa8; }
      body { margin: 0 auto; padding: 1.5rem 1rem 4rem; max-width: 58rem; background: var(--paper);
        color: var(--ink); font: 1rem/1.55 system-ui, "Segoe UI", Roboto, sans-serif; }
      h1 { font-size: 1.75rem; line-height: 1.2; margin: 0 0 .4rem; }
      h2 { font-size: 1.2rem; margin: 2.4rem 0 .6rem; border-top: 1px solid var(--line);
        padding-top: 1.2rem; }
      p, ul { margin: .5rem 0; max-width: 46rem; overflow-wrap: break-word; }
      ul { padding-left: 1.2rem; }
      li { margin: .35rem 0; }
      .lead, .caption, figcaption { color: var(--soft); }
      .caption, figcaption { font-size: .93rem; margin: 0 0 .4rem; }
      .verdict { background: var(--wash); border-left: 4px solid var(--accent); max-width: none;
        padding: .8rem 1.2rem .8rem 2.1rem; }
      .wide { overflow-x: auto; }
      table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .93rem; }
      th, td { padding: .28rem .7rem; text-align: right; white-space: nowrap;
        border-top: 1px solid var(--line); }
      td.note { text-align: left; color: var(--soft); }
      tr.part th { text-align: left; padding-top: .9rem; }
      tr.part span { position: sticky; left: 0; }
      .sheet { position: relative; left: 50%; transform: translateX(-50%); width: max-content;
        max-width: calc(100vw - 2rem); }
      .sheet table { font-size: .75rem; }
      .sheet th, .sheet td { padding: .2rem .38rem; }
      .sheet tr > :first-child { position: sticky; left: 0;
        background: var(--paper) padding-box; }
      tr.more td { border-top-style: none; padding-top: 0; }
      th { font-weight: 600; white-space: normal; vertical-align: bottom; }
      th:first-child, td:first-child { text-align: left; padding-left: 0; }
      figure { margin: 1.4rem 0; }
      figure > div { display: grid; gap: .8rem;
        grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); }
      figure > div.photos { grid-template-columns: repeat(3, 1fr); }
      .photos p { margin: 0; color: var(--soft); font-size: .85rem; }
      .photos img { width: 100%; max-width: 16rem; height: auto; }
      figure svg { width: 100%; max-width: 32rem; height: auto; }
      pre { background: var(--wash); padding: .7rem .9rem; overflow-x: auto; font-size: .9rem; }
      a { color: var(--accent); }
      @media (max-width: 32rem) {
        th, td { padding: .25rem .22rem; }
        table { font-size: .75rem; }
        .sheet td:first-child { white-space: normal; min-width: 7rem; }
      }
      """;

  private static final String DARK =
      "--paper: #15181c; --ink: #e4e7ea; --soft: #a3abb4; --line: #343a41; --wash: #1e2328;"
          + " --accent: #6cb0f5;";

  private static final String PAPER =
      """
      @media print {
        body { max-width: none; padding: 0; font-size: 10pt; }
        figure svg, p, tr, .verdict { break-inside: avoid; }
        h2, .caption, figcaption, p:has(+ figure) { break-after: avoid; }
        figure > div { grid-template-columns: 1fr 1fr; }
        figure > div.photos { break-inside: avoid; }
        .wide, pre { overflow: visible; }
        pre { white-space: pre-wrap; }
        .sheet, p:has(+ .sheet), h2:has(+ p + .sheet) { page: sheet; }
        .sheet { left: 0; transform: none; max-width: none; }
        .sheet table { font-size: 7pt; }
        .sheet th, .sheet td { padding: .1rem .3rem; }
        .sheet tr > :first-child { position: static; }
      }
      @page sheet { size: A4 landscape; }
      """;

  private static final Pattern UNIT =
      Pattern.compile("(?<=\\d) (?=%|(?:s|ms|[uµ]s|x|mD|voxels?|bytes?|[KMG]iB)\\b)");

  /** A table of more columns takes what width there is, and turns the paper. */
  private static final int SHEET = 12;

  private final StringBuilder html = new StringBuilder();

  /**
   * A page that has only its head.
   *
   * @param title what it is about
   * @param lead what was looked at, in a line
   */
  public StudyPage(String title, String lead) {
    line("<!DOCTYPE html>");
    line("<html lang=\"en\">");
    line("<head>");
    line("<meta charset=\"utf-8\"/>");
    line("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>");
    element("title", title);
    line("<style>");
    html.append(STYLE).append(inTheDark()).append(PAPER);
    line("</style>");
    line("</head>");
    line("<body>");
    element("h1", title);
    line("<p class=\"lead\">" + text(lead) + "</p>");
  }

  private static String inTheDark() {
    StringBuilder style = new StringBuilder("@media screen and (prefers-color-scheme: dark) {\n");
    style.append("  :root { ").append(DARK).append(" }\n");
    style.append("  svg text { fill: var(--ink); }\n");
    for (PlotInk ink : PlotInk.values()) {
      for (String what : List.of("fill", "stroke")) {
        style.append(
            String.format("  svg [%s=\"%s\"] { %1$s: %s; }%n", what, ink.light(), ink.dark()));
      }
    }
    return style.append("}\n").toString();
  }

  private void line(String markup) {
    html.append(markup).append(System.lineSeparator());
  }

  private void element(String name, String text) {
    line("<" + name + ">" + text(text) + "</" + name + ">");
  }

  /** A text in which no line ends between a number and its unit. */
  private static String text(String text) {
    return Markup.escaped(UNIT.matcher(text).replaceAll("\u00a0"));
  }

  /** Begins a section. */
  public StudyPage section(String heading) {
    element("h2", heading);
    return this;
  }

  /** Adds a paragraph. */
  public StudyPage paragraph(String text) {
    element("p", text);
    return this;
  }

  /** Adds what the study found, sentence by sentence. */
  public StudyPage verdict(List<String> sentences) {
    return list("<ul class=\"verdict\">", sentences);
  }

  /** Adds some points. */
  public StudyPage points(List<String> points) {
    return list("<ul>", points);
  }

  private StudyPage list(String tag, List<String> items) {
    line(tag);
    items.forEach(item -> element("li", item));
    line("</ul>");
    return this;
  }

  /**
   * Adds a table. A row whose first cell is empty belongs to the one above. In a row of fewer cells
   * than the head the last one is a remark that takes the place of the others; if it is the only
   * one, it is a heading of the rows below.
   */
  public StudyPage table(String caption, List<String> head, List<List<String>> rows) {
    line("<p class=\"caption\">" + text(caption) + "</p>");
    line(head.size() > SHEET ? "<div class=\"wide sheet\">" : "<div class=\"wide\">");
    line("<table>");
    line("<thead>");
    row("th", head, head.size());
    line("</thead>");
    line("<tbody>");
    rows.forEach(row -> row("td", row, head.size()));
    line("</tbody>");
    line("</table>");
    line("</div>");
    return this;
  }

  private void row(String cell, List<String> texts, int columns) {
    int last = texts.size() - 1;
    String spans = " colspan=\"" + (columns - last) + "\"";
    if (last == 0 && columns > 1) {
      String part = text(texts.get(0));
      line("<tr class=\"part\"><th" + spans + "><span>" + part + "</span></th></tr>");
      return;
    }
    StringBuilder row = new StringBuilder(texts.get(0).isEmpty() ? "<tr class=\"more\">" : "<tr>");
    for (int n = 0; n <= last; n++) {
      row.append('<').append(cell);
      row.append(n == last && columns > texts.size() ? " class=\"note\"" + spans : "");
      row.append('>').append(text(texts.get(n))).append("</").append(cell).append('>');
    }
    line(row + "</tr>");
  }

  /** Adds pictures, beside each other where there is room. */
  public StudyPage figure(String caption, List<String> pictures) {
    line("<figure>");
    element("figcaption", caption);
    line("<div>");
    pictures.forEach(html::append);
    line("</div>");
    line("</figure>");
    return this;
  }

  /**
   * A picture of pixels that is part of the page.
   *
   * @param png its file
   * @param title what it shows, for those who cannot see it
   */
  public record Photo(byte[] png, String title) {}

  /** Adds pictures of pixels with their titles, beside each other where there is room. */
  public StudyPage photos(String caption, List<Photo> photos) {
    line("<figure>");
    element("figcaption", caption);
    line("<div class=\"photos\">");
    for (Photo each : photos) {
      line(
          "<p><img alt=\""
              + Markup.escaped(each.title())
              + "\" src=\"data:image/png;base64,"
              + Base64.getEncoder().encodeToString(each.png())
              + "\"/><br/>"
              + text(each.title())
              + "</p>");
    }
    line("</div>");
    line("</figure>");
    return this;
  }

  /** Adds a command line, or several. */
  public StudyPage command(String lines) {
    line("<pre>" + Markup.escaped(lines) + "</pre>");
    return this;
  }

  /** Adds links to files that lie beside the page. */
  public StudyPage files(List<String> names) {
    line("<ul>");
    for (String name : names) {
      line("<li><a href=\"" + Markup.escaped(name) + "\">" + Markup.escaped(name) + "</a></li>");
    }
    line("</ul>");
    return this;
  }

  /** The whole page. */
  @Override
  public String toString() {
    return html + "</body>" + System.lineSeparator() + "</html>" + System.lineSeparator();
  }
}
