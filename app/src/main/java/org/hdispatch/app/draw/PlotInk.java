package org.hdispatch.app.draw;

/** Colours of plots: as they are drawn, on white, and what a page makes of them in the dark. */
public enum PlotInk {
  /** The ground; also the inside of open marks. */
  PAPER("white", "#15181c"),
  /** Axes. */
  GREY("#888888", "#8b929a"),
  /** Grids. */
  PALE("#dddddd", "#343a41"),
  /** What the plot is about. */
  FIRST("#1f5fa8", "#6cb0f5"),
  /** What it is compared with. */
  SECOND("#c25a00", "#f5a04c"),
  /** What else it is compared with. */
  THIRD("#23804c", "#62c98c"),
  /** What comes on top, whatever the colour below. */
  DARK("#2a2f35", "#e9ecef");

  private final String light;
  private final String dark;

  PlotInk(String light, String dark) {
    this.light = light;
    this.dark = dark;
  }

  /** The colour that is drawn. */
  public String light() {
    return light;
  }

  /** The colour in the dark. */
  public String dark() {
    return dark;
  }
}
