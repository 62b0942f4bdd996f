package org.hdispatch.app.draw;

import java.util.List;
import org.hdispatch.app.draw.Drawing.Anchor;

/** Bars to the right, in groups, each in two parts; small enough for a phone. */
public final class BarPlot {
  private static final int WIDTH = 420;
  private static final int LEFT = 124;
  private static final int RIGHT = 96;
  private static final int HEADING = 22;
  private static final int NAME = 22; // above each group
  private static final int PITCH = 17;
  private static final int BAR = 12;
  private static final int BOTTOM = 46;
  private static final int LEGEND = 226;

  /** Between the parts of a bar. */
  private static final double SLIT = 1;

  private BarPlot() {}

  /**
   * A bar.
   *
   * @param name at its left
   * @param first length of its first part
   * @param second length of its second part
   * @param note at its right
   * @param ink of its first part; the second is dark
   */
  public record Bar(String name, double first, double second, String note, PlotInk ink) {}

  /**
   * Bars that belong together.
   *
   * @param name above them
   * @param bars from top to bottom
   */
  public record Group(String name, List<Bar> bars) {}

  /**
   * The picture as SVG.
   *
   * @param heading what is shown
   * @param second what the second part of the bars is
   * @param axis of the bars, from zero
   */
  public static String of(String heading, String second, PlotAxis axis, List<Group> groups) {
    int bars = groups.stream().mapToInt(group -> group.bars().size()).sum();
    int bottom = HEADING + groups.size() * NAME + bars * PITCH + 4;
    SvgWriter svg = new SvgWriter(WIDTH, bottom + BOTTOM, heading);
    svg.text(0, 14, heading, Anchor.START, 0);
    svg.name(LEGEND, 14, second, PlotInk.DARK.light());
    int room = WIDTH - LEFT - RIGHT;
    for (double tick : axis.ticks()) {
      double x = LEFT + room * axis.place(tick);
      svg.line(x, HEADING + 4, x, bottom + 4, PlotInk.PALE.light(), "");
      svg.text(x, bottom + 18, axis.label().apply(tick), Anchor.MIDDLE, 0);
    }
    svg.text(LEFT + room / 2.0, bottom + 38, axis.title(), Anchor.MIDDLE, 0);
    int top = HEADING;
    for (Group group : groups) {
      svg.text(0, top + NAME - 5, group.name(), Anchor.START, 0);
      top += NAME;
      for (Bar bar : group.bars()) {
        draw(svg, top, room, axis, bar);
        top += PITCH;
      }
    }
    svg.line(LEFT, HEADING + 4, LEFT, bottom, PlotInk.GREY.light(), "");
    return svg.toString();
  }

  private static void draw(SvgWriter svg, int top, int room, PlotAxis axis, Bar bar) {
    double first = room * axis.place(bar.first());
    double all = room * axis.place(bar.first() + bar.second());
    svg.text(LEFT - 6, top + BAR - 1, bar.name(), Anchor.END, 0);
    svg.rectangle(LEFT, top, first, BAR, bar.ink().light());
    double second = all - first - SLIT;
    if (second > 0) {
      svg.rectangle(LEFT + first + SLIT, top, second, BAR, PlotInk.DARK.light());
    }
    svg.text(LEFT + all + 6, top + BAR - 1, bar.note(), Anchor.START, 0);
  }
}
