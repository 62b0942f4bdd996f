package org.hdispatch.app.draw;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.TreeSet;
import java.util.function.DoubleFunction;
import org.hdispatch.app.draw.Drawing.Anchor;
import org.hdispatch.porous.image.VoxelBox;

/**
 * Blocks of an image, coloured by a value of theirs: layer by layer along z, each seen from above,
 * x to the right and y downwards; small enough for a phone.
 */
public final class BlockMap {
  private static final int WIDTH = 420;
  private static final int HEADING = 24;
  private static final int NAME = 18; // above each layer
  private static final int GAP = 12;
  private static final int SCALE = 58; // height of the colour scale with its numbers
  private static final int STEPS = 60; // of the colour scale
  private static final int ACROSS = 4; // layers in a row, at most
  private static final double LEAST_ROOM = 60; // of a layer, pixels

  private BlockMap() {}

  /**
   * A block.
   *
   * @param box where it lies
   * @param value its value; empty if there is none
   */
  public record Block(VoxelBox box, OptionalDouble value) {}

  /**
   * The picture as SVG.
   *
   * @param heading what is shown
   * @param without what it means that a block has no value
   * @param blocks the blocks, those of the first layers if there are many
   * @param axis from the least value to the greatest: the place on it is the colour
   */
  public static String of(String heading, String without, List<Block> blocks, PlotAxis axis) {
    List<Integer> layers = layers(blocks);
    int x0 = blocks.stream().mapToInt(each -> each.box().x0()).min().orElseThrow();
    int y0 = blocks.stream().mapToInt(each -> each.box().y0()).min().orElseThrow();
    int wide =
        blocks.stream().mapToInt(each -> each.box().x0() + each.box().nx()).max().orElseThrow()
            - x0;
    int high =
        blocks.stream().mapToInt(each -> each.box().y0() + each.box().ny()).max().orElseThrow()
            - y0;
    int across = Math.min(ACROSS, Math.max(2, layers.size()));
    double room = (WIDTH - (across - 1.0) * GAP) / across;
    double pixels = Math.min(room / wide, 2 * room / high);
    double pitch = NAME + Math.max(LEAST_ROOM, high * pixels) + GAP;
    int rows = (layers.size() + across - 1) / across;
    int height = (int) Math.ceil(HEADING + rows * pitch + SCALE);
    SvgWriter svg = new SvgWriter(WIDTH, height, heading);
    svg.text(0, 14, heading, Anchor.START, 0);
    for (int n = 0; n < layers.size(); n++) {
      double left = n % across * (room + GAP);
      double top = HEADING + n / across * pitch + NAME;
      int z0 = layers.get(n);
      svg.text(left, top - 5, "z0 = " + z0, Anchor.START, 0);
      for (Block block : blocks) {
        VoxelBox box = block.box();
        if (box.z0() == z0) {
          tile(
              svg,
              left + (box.x0() - x0) * pixels,
              top + (box.y0() - y0) * pixels,
              box.nx() * pixels,
              box.ny() * pixels,
              block.value(),
              axis);
        }
      }
    }
    boolean all = blocks.stream().allMatch(each -> each.value().isPresent());
    scale(svg, HEADING + rows * pitch, axis, all ? "" : without);
    return svg.toString();
  }

  /** Where layers of blocks begin along z, ascending. */
  public static List<Integer> layers(List<Block> blocks) {
    TreeSet<Integer> layers = new TreeSet<>();
    blocks.forEach(each -> layers.add(each.box().z0()));
    return List.copyOf(layers);
  }

  private static String colour(double place) {
    return String.format(Locale.ROOT, "#%06x", ColourMap.viridis(place));
  }

  private static void tile(
      Drawing drawing,
      double x,
      double y,
      double width,
      double height,
      OptionalDouble value,
      PlotAxis axis) {
    double slit = Math.min(1, width / 8);
    if (value.isPresent()) {
      drawing.rectangle(x, y, width - slit, height - slit, colour(axis.place(value.getAsDouble())));
    } else {
      drawing.rectangle(x, y, width - slit, height - slit, PlotInk.PALE.light());
      drawing.line(x, y + height - slit, x + width - slit, y, PlotInk.GREY.light(), "");
    }
  }

  private static void scale(Drawing drawing, double top, PlotAxis axis, String without) {
    double length = without.isEmpty() ? WIDTH - 40 : WIDTH - 190;
    double step = length / STEPS;
    for (int n = 0; n < STEPS; n++) {
      drawing.rectangle(10 + n * step, top + 4, step + 0.3, 10, colour((n + 0.5) / STEPS));
    }
    DoubleFunction<String> label = axis.label();
    double last = Double.NEGATIVE_INFINITY;
    for (double tick : axis.ticks()) {
      double x = 10 + length * axis.place(tick);
      double half = Drawing.LETTER * label.apply(tick).length() / 2;
      if (x - half > last) {
        drawing.line(x, top + 14, x, top + 18, PlotInk.GREY.light(), "");
        drawing.text(x, top + 31, label.apply(tick), Anchor.MIDDLE, 0);
        last = x + half + 4;
      }
    }
    drawing.text(10, top + 49, axis.title(), Anchor.START, 0);
    if (!without.isEmpty()) {
      tile(drawing, length + 34, top + 4, 12, 12, OptionalDouble.empty(), axis);
      drawing.text(length + 52, top + 14, without, Anchor.START, 0);
    }
  }
}
